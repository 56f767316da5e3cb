//! Enumerations whose variants have a name and a description.

/// Declares an enumeration, the list `ALL` of its variants, and the `name` and the description `about` of each.
macro_rules! described {
    (
        $(#[$meta:meta])*
        $type:ident { $($(#[$doc:meta])* $variant:ident = $name:literal: $about:literal,)+ }
    ) => {
        $(#[$meta])*
        pub enum $type {
            $(#[doc = $about] $(#[$doc])* $variant,)+
        }

        impl $type {
            /// All of them, in the order of reports.
            pub const ALL: [Self; [$(Self::$variant),+].len()] = [$(Self::$variant),+];

            /// The name on the command line and in reports.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }

            /// A description in one line.
            pub const fn about(self) -> &'static str {
                match self {
                    $(Self::$variant => $about,)+
                }
            }
        }
    };
}
pub(super) use described;
