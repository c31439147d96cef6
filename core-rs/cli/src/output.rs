//! Where answers go: standard output, or a file that is whole or not there.

use std::fs::{self, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// Prints text and ends the line.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let line_end = if text.ends_with('\n') { "" } else { "\n" };
    out.write_all(text.as_bytes()).and_then(|()| out.write_all(line_end.as_bytes())).and_then(|()| out.flush()).map_err(Failure::printing)
}

/// Writes text to a file under another name and renames it, so that nobody ever sees half of it.
pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    write_whole(path, text).map_err(|error| Failure::writing(error, path))
}

fn write_whole(path: &Path, text: &str) -> io::Result<()> {
    // A link is written through, and what is no file (a pipe, a terminal) cannot be replaced by one.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(&target).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        return OpenOptions::new().write(true).open(&target)?.write_all(text.as_bytes());
    }
    let mut file = temporary_beside(&target)?;
    file.write_all(text.as_bytes())?;
    if !text.ends_with('\n') {
        file.write_all(b"\n")?;
    }
    file.as_file().sync_all()?;
    file.persist(&target)?;
    Ok(())
}

fn temporary_beside(target: &Path) -> io::Result<tempfile::NamedTempFile> {
    let parent = target.parent().filter(|parent| !parent.as_os_str().is_empty()).map_or_else(|| PathBuf::from("."), Path::to_owned);
    let mut builder = tempfile::Builder::new();
    builder.prefix(".eigenform-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        // As any new file: the process's mask decides. A temporary file is its owner's alone otherwise.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    // The temporary name is in the error; the folder is what a person knows.
    builder.tempfile_in(&parent).map_err(|error| match error.kind() {
        kind @ (io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
            io::Error::new(kind, format!("there is no folder {}", parent.display()))
        }
        kind => kind.into(),
    })
}
