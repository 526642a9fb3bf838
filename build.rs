//! Has the program built anew when a level or a chapter is added: `include_dir!` itself only
//! notices changes to files that it already knows.

fn main() {
    println!("cargo::rerun-if-changed=levels");
    println!("cargo::rerun-if-changed=assets/lessons");
}
