//! Numbers without meshes (layer 0).
