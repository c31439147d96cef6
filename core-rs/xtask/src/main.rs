//! Builds what the page needs from the engine.
//!
//!     cargo xtask wasm DIR     the wasm package (engine.js, engine_bg.wasm) into DIR
//!     cargo xtask types FILE   the page's TypeScript types into FILE

mod package;
mod types;

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let outcome = match words[..] {
        ["wasm", directory] => package::build(Path::new(directory)),
        ["types", file] => std::fs::write(file, types::typescript()).map_err(|error| format!("{file} cannot be written: {error}")),
        _ => Err("usage: cargo xtask wasm DIR | types FILE".to_owned()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}
