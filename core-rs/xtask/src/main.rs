//! Tasks.
mod types;
fn main() {
    print!("{}", types::typescript());
}
