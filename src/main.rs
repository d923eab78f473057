//! rayproof's command line.

fn main() {}
