//! The wasm package of the page, without wasm-pack: cargo compiles, wasm-bindgen's library writes the glue.

use std::path::{Path, PathBuf};
use std::process::Command;

use wasm_bindgen_cli_support::Bindgen;

/// What the page loads, by the name it has there: the engine at first, the others when they are wanted.
const PACKAGES: [Package; 3] = [
    Package { name: "engine", member: "eigenform-wasm", features: &[] },
    Package { name: "workshop", member: "eigenform-wasm", features: &["workshop"] },
    Package { name: "shapes", member: "eigenform-shapes", features: &[] },
];

struct Package {
    name: &'static str,
    member: &'static str,
    features: &'static [&'static str],
}

const TARGET: &str = "wasm32-unknown-unknown";

/// Compiles the engine for the browser and writes its packages into `directory`.
pub fn build(directory: &Path) -> Result<(), String> {
    for Package { name, member, features } in PACKAGES {
        let status = Command::new(env!("CARGO"))
            .args(["build", "--profile", "page", "--target", TARGET, "--package", member, "--no-default-features"])
            .args(["--features", &features.join(",")])
            .current_dir(workspace())
            .status()
            .map_err(|error| format!("cargo did not start: {error}"))?;
        if !status.success() {
            return Err("the engine does not compile for the browser".to_owned());
        }
        bind(&member.replace('-', "_"), name, directory)?;
    }
    Ok(())
}

fn bind(file: &str, name: &str, directory: &Path) -> Result<(), String> {
    // Without a default module path the page names the wasm file itself, and the bundler sees the name.
    Bindgen::new()
        .input_path(target_directory().join(TARGET).join(format!("page/{file}.wasm")))
        .web(true)
        .and_then(|bindgen| {
            bindgen
                .typescript(true)
                .remove_name_section(true)
                .remove_producers_section(true)
                .omit_default_module_path(true)
                .out_name(name)
                .generate(directory)
        })
        .map_err(|error| format!("wasm-bindgen: {error:#}"))
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lives in the workspace").to_owned()
}

fn target_directory() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| workspace().join("target"), PathBuf::from)
}
