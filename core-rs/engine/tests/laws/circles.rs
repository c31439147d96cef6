//! No two files know each other, not by way of others either: each can be read after those that it names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// By the path of its module, as `scene::link`, the file of it.
fn modules(folder: &Path, within: &[String]) -> BTreeMap<Vec<String>, PathBuf> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let own = || [within, std::slice::from_ref(&name)].concat();
        if path.is_dir() {
            found.append(&mut modules(&path, &own()));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let is_root = ["lib", "mod"].contains(&name.as_str());
            found.insert(if is_root { within.to_vec() } else { own() }, path);
        }
    }
    found
}

/// The code of a file, without remarks and tests.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("the file can be read");
    let tested = text.find("#[cfg(test)]\nmod tests {").unwrap_or(text.len());
    text[..tested].lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// Paths that start at the crate or at the module around, with what stands in braces written out.
fn paths(code: &str) -> Vec<Vec<String>> {
    let mut found = vec![];
    for start in ["crate::", "super::"] {
        for (at, _) in code.match_indices(start) {
            let is_start = !code[..at].ends_with(|before: char| before.is_alphanumeric() || before == '_' || before == ':');
            if is_start {
                write_out(&code[at..], &[], &mut found);
            }
        }
    }
    found
}

/// Reads one path off the front of `text`, or several in braces; what is left behind them.
fn write_out<'a>(text: &'a str, before: &[String], found: &mut Vec<Vec<String>>) -> &'a str {
    let mut path = before.to_vec();
    let mut rest = text.trim_start();
    loop {
        if let Some(mut inner) = rest.strip_prefix('{') {
            while !inner.trim_start().starts_with('}') {
                inner = write_out(inner, &path, found).trim_start();
                inner = inner.strip_prefix(',').unwrap_or(inner);
            }
            return &inner.trim_start()[1..];
        }
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        path.push(rest[..end].to_owned());
        rest = &rest[end..];
        match rest.strip_prefix("::") {
            Some(next) if next.starts_with(|c: char| c.is_alphabetic() || c == '_' || c == '{') => rest = next,
            _ => break,
        }
    }
    found.push(path);
    let renamed = rest.trim_start().strip_prefix("as ");
    renamed.map_or(rest, |name| name.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_'))
}

/// The module that a path leads into from `own`, as deep as there are files.
fn target(path: &[String], own: &[String], modules: &BTreeMap<Vec<String>, PathBuf>) -> Vec<String> {
    let ups = path.iter().take_while(|word| *word == "super").count();
    let mut at = if ups == 0 { vec![] } else { own[..own.len().saturating_sub(ups)].to_vec() };
    for word in &path[ups.max(1)..] {
        let deeper = [&at[..], std::slice::from_ref(word)].concat();
        if !modules.contains_key(&deeper) {
            break;
        }
        at = deeper;
    }
    at
}

#[test]
fn no_file_knows_one_that_knows_it() {
    let modules = modules(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &[]);
    let mut known: BTreeMap<&[String], BTreeSet<Vec<String>>> = BTreeMap::new();
    for (own, path) in &modules {
        let targets = paths(&code(path)).into_iter().map(|path| target(&path, own, &modules));
        // A room's front and what is inside belong together.
        known.insert(own, targets.filter(|other| !other.starts_with(own) && !own.starts_with(other)).collect());
    }
    assert!(known.values().map(BTreeSet::len).sum::<usize>() > modules.len(), "hardly a file names another: the reading is wrong");
    // Whoever knows nobody that is left can be read now.
    while let Some(own) = known.iter().find(|(_, others)| others.iter().all(|other| !known.contains_key(&other[..]))).map(|(own, _)| *own) {
        known.remove(own);
    }
    assert!(known.is_empty(), "files that know each other, or one that does: {known:#?}");
}
