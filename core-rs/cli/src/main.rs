//! Eigenform on the command line: the page's engine for scripts, farms and tests.
//!
//! Each verb reads a scene, asks the engine and prints. A refusal is one line on stderr and an exit code; nothing half-written is left.

mod arguments;
mod failure;
mod input;
mod output;
mod picture;
mod verbs;

use std::io::{self, Write as _};
use std::process::ExitCode;

use clap::Parser as _;

use arguments::{Arguments, Verb};
use failure::Failure;

fn main() -> ExitCode {
    match parse().and_then(|verb| run(&verb)) {
        Ok(notes) => {
            say(&notes);
            ExitCode::SUCCESS
        }
        Err(failure) => failure.report(),
    }
}

fn parse() -> Result<Verb, Failure> {
    Arguments::try_parse_from(arguments::typed()).map(|arguments| arguments.verb).map_err(Failure::from)
}

/// A sentence a line on stderr, once all went well: a failure is a single line.
fn say(notes: &[String]) {
    for note in notes {
        // Whoever closed stderr does not want to know.
        let _ = writeln!(io::stderr(), "note: {note}");
    }
}

/// Does it, and gives what there is to say about it.
fn run(verb: &Verb) -> Result<Vec<String>, Failure> {
    match verb {
        Verb::Motion(motion) => verbs::motion::run(motion),
        Verb::Measure(measure) => verbs::measure::run(measure),
        Verb::Compare(compare) => verbs::compare::run(compare),
        Verb::Spread(spread) => verbs::spread::run(spread),
        Verb::Modes(modes) => verbs::modes::run(modes),
        Verb::Assign(assign) => verbs::assign::run(assign),
        Verb::Shape(shape) => verbs::shape::run(shape),
        Verb::Groups(groups) => verbs::groups::run(groups),
        Verb::Link(link) => verbs::link::run(link),
        Verb::Open(open) => verbs::open::run(open),
        Verb::Convert(convert) => verbs::convert::run(convert),
        Verb::Check(check) => verbs::check::run(check),
    }
}
