//! Face, vertex and corner normals (layer 2).
