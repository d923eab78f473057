// Nothing is counted.

fn count_bound(hit: ptr<function, Hit>, met: bool) {
}

fn keep_counts(index: u32, hit: Hit) {
}
