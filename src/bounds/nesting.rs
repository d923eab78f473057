//! What lies in what: groups in groups, meshes in groups.

/// The children of each of some things that know their parents.
pub(super) struct Nesting {
    children: Vec<Vec<usize>>,
    outermost: Vec<usize>,
}

impl Nesting {
    /// From the parent of each. A parent stands before its children.
    pub(super) fn of(parents: impl ExactSizeIterator<Item = Option<usize>>) -> Self {
        let mut nesting = Self {
            children: vec![Vec::new(); parents.len()],
            outermost: Vec::new(),
        };
        for (index, parent) in parents.enumerate() {
            match parent {
                Some(parent) => nesting.children[parent].push(index),
                None => nesting.outermost.push(index),
            }
        }
        nesting
    }

    /// Those without a parent.
    pub(super) fn outermost(&self) -> &[usize] {
        &self.outermost
    }

    /// Those whose parent is `index`.
    pub(super) fn children(&self, index: usize) -> &[usize] {
        &self.children[index]
    }

    /// `index` itself and all that is in it, however deep; the parent first.
    pub(super) fn with_all_in(&self, index: usize) -> impl Iterator<Item = usize> {
        let mut waiting = vec![index];
        std::iter::from_fn(move || {
            let next = waiting.pop()?;
            waiting.extend(self.children(next).iter().rev());
            Some(next)
        })
    }
}
