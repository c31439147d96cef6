//! What ends a run early: one line on stderr and an exit code.

use std::error::Error as _;
use std::fmt::{self, Display, Formatter};
use std::io::{self, Write as _};
use std::path::Path;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue};
use eigenform::error::Error;

use crate::input::quoted;

/// Bad input or usage.
const INPUT: u8 = 2;

/// A file that cannot be read or written.
const FILE: u8 = 1;

/// How a recording becomes a scene.
const FROM_RECORDING: &str = "eigenform convert RECORDING show.eigenform.json --frames 0,120 makes one of frames 0 and 120";

/// Why a run ended early.
#[derive(Debug)]
pub enum Failure {
    /// The engine refuses the input.
    Refused(Error),
    /// What was given is no shape that can be drawn.
    Given { code: &'static str, what: String, place: String },
    /// The command is not one.
    Usage { what: String, place: String },
    /// A file cannot be read or written.
    File { code: &'static str, error: io::Error, path: String },
    /// Help was asked for, or whoever read the output has had enough.
    Nothing(String),
}

impl Failure {
    /// A command that is not one, and which part of it.
    pub fn usage(what: impl Into<String>, place: impl Into<String>) -> Self {
        Self::Usage { what: what.into(), place: place.into() }
    }

    /// A file that cannot be read.
    pub fn reading(error: io::Error, path: &Path) -> Self {
        Self::File { code: "cannot-read", error, path: path.display().to_string() }
    }

    /// A file that cannot be written.
    pub fn writing(error: io::Error, path: &Path) -> Self {
        Self::File { code: "cannot-write", error, path: path.display().to_string() }
    }

    /// Standard output that cannot be written; a reader that stops early is no failure.
    pub fn printing(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Nothing(String::new()),
            _ => Self::writing(error, Path::new("standard output")),
        }
    }

    /// Says it and gives the exit code.
    pub fn report(self) -> ExitCode {
        if let Self::Nothing(help) = self {
            // Help for a reader that has gone needs no answer.
            let _ = io::stdout().write_all(help.as_bytes());
            return ExitCode::SUCCESS;
        }
        let _ = writeln!(io::stderr(), "error: {self}");
        ExitCode::from(if matches!(self, Self::File { .. }) { FILE } else { INPUT })
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Refused(error)
    }
}

impl From<clap::Error> for Failure {
    fn from(error: clap::Error) -> Self {
        if !error.use_stderr() {
            return Self::Nothing(error.to_string());
        }
        if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
            return Self::usage("what is to be done is missing", "eigenform --help lists the verbs");
        }
        if let Some(failure) = mistyped(&error).or_else(|| missing(&error)) {
            return failure;
        }
        let text = error.to_string();
        // The first paragraph says what is wrong; tips and the usage follow it.
        let lines = text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim);
        let what = lines.collect::<Vec<_>>().join(" ");
        Self::usage(what.strip_prefix("error: ").unwrap_or(&what), "eigenform --help, or the verb's")
    }
}

/// A value that is none: what was typed, why not, and the option.
fn mistyped(error: &clap::Error) -> Option<Failure> {
    let typed = |kind: ContextKind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        _ => None,
    };
    let (value, argument, why) = (typed(ContextKind::InvalidValue)?, typed(ContextKind::InvalidArg)?, error.source()?);
    Some(Failure::usage(format!("{} {why}", quoted(value)), argument.split(' ').next().unwrap_or(argument)))
}

/// What has to be given and was not.
fn missing(error: &clap::Error) -> Option<Failure> {
    let Some(ContextValue::Strings(arguments)) = error.get(ContextKind::InvalidArg) else { return None };
    let are = if arguments.len() > 1 { "are" } else { "is" };
    let what = format!("{} {are} missing", arguments.join(" and "));
    (error.kind() == clap::error::ErrorKind::MissingRequiredArgument).then(|| Failure::usage(what, "the verb's --help has an example"))
}

impl Display for Failure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (code, what, place) = match self {
            Self::Refused(error @ Error::IsRecording) => (error.code(), format!("{error}: {FROM_RECORDING}"), error.place()),
            Self::Refused(error) => (error.code(), error.to_string(), error.place()),
            Self::Given { code, what, place } => (*code, what.clone(), place.clone()),
            Self::Usage { what, place } => ("usage", what.clone(), place.clone()),
            Self::File { code, error, path } => (*code, in_words(error), path.clone()),
            Self::Nothing(_) => return Ok(()),
        };
        write!(f, "{code}: {}", on_one_line(&what))?;
        if place.is_empty() { Ok(()) } else { write!(f, " ({})", on_one_line(&place)) }
    }
}

/// What the system says, without its number.
fn in_words(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::IsADirectory => "this is a folder, not a file".to_owned(),
        io::ErrorKind::NotFound if error.raw_os_error().is_some() => "there is no such file".to_owned(),
        kind if error.raw_os_error().is_some() => kind.to_string(),
        _ => error.to_string(),
    }
}

/// What a person typed may hold line ends; an error is one line.
fn on_one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::Failure;

    #[test]
    fn a_failure_is_one_line_whatever_was_typed() {
        let failure = Failure::usage("no verb \"a\nb\"", "line\u{1b}[31m");
        assert_eq!(failure.to_string(), "usage: no verb \"a b\" (line [31m)");
    }
}
