//! File names in commands that are suggested.

use std::borrow::Cow;

/// A file name as it is typed in a POSIX shell: quoted where it has to be, and never to be taken for an option. `-` alone
/// stands for a stream and stays.
///
/// ```
/// assert_eq!(crease::io::shell_word("it's here.obj"), "\"it's here.obj\"");
/// ```
pub fn shell_word(name: &str) -> Cow<'_, str> {
    let path =
        if name.len() > 1 && name.starts_with('-') { Cow::from(format!("./{name}")) } else { name.into() };
    // A file name has no NUL, the only character that cannot be quoted.
    shlex::try_quote(&path).map(|word| word.into_owned().into()).unwrap_or(name.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_back_from_a_shell() {
        for name in
            ["a.obj", "a b.obj", "it's.obj", "$HOME/`x`.obj", "\"\\.obj", "ä.obj", "-x.obj", "-", "a\nb.obj"]
        {
            let line = format!("crease normals {} -o out.glb", shell_word(name));
            let words = shlex::split(&line).unwrap();
            let expected = if name == "-x.obj" { "./-x.obj" } else { name };
            assert_eq!(words, ["crease", "normals", expected, "-o", "out.glb"], "{line}");
        }
        assert_eq!(shell_word("models/a-1.obj"), "models/a-1.obj");
    }
}
