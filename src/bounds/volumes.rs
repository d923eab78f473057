//! A list of volumes, each before what it holds: around the groups of the scene, or
//! around groups and meshes, and within each as many levels as wanted.

use super::arrange::arrange;
use super::held::Held;
use super::nesting::Nesting;
use crate::flat::{Flat, GivenBound};
use crate::kernel::real::Real;
use crate::layout::{BOX, BallRecord, BoxRecord, EVERYTHING, LEAF_KIND, Volume};

/// Which volumes a list has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Listing {
    /// Those of the scene's groups, as the scene says.
    Given,
    /// A ball around each group and mesh, and so many levels of them.
    Balls(u32),
    /// A box around each group and mesh, and so many levels of them.
    Boxes(u32),
}

/// Parts into which a volume's contents are cut a level.
const BRANCHES: usize = 4;

/// Fills the list of volumes, and puts the primitives into its order.
pub(super) fn list_volumes<R: Real>(flat: &mut Flat<R>, listing: Listing) {
    let held = Held::of(flat);
    let nesting = Nesting::of(flat.parts.iter().map(|part| part.parent));
    let mut list = List {
        flat,
        held: &held,
        nesting: &nesting,
        listing,
        entries: Vec::new(),
        ids: Vec::new(),
        balls: Vec::new(),
        boxes: Vec::new(),
    };
    list.push_all();
    let List {
        mut entries,
        ids,
        balls,
        boxes,
        ..
    } = list;
    let rows = arrange(flat, &ids);
    for entry in entries.iter_mut().filter(|entry| entry.count > 0) {
        let (kind, _) = flat.kind_of(ids[entry.first as usize]);
        entry.first = (kind as u32) << LEAF_KIND | rows[entry.first as usize];
    }
    (flat.volumes, flat.balls, flat.boxes) = (entries, balls, boxes);
}

/// The list as it grows. First rows are places in `ids` until these are arranged.
struct List<'a, R> {
    flat: &'a Flat<R>,
    held: &'a Held,
    nesting: &'a Nesting,
    listing: Listing,
    entries: Vec<Volume>,
    ids: Vec<u32>,
    balls: Vec<BallRecord<R>>,
    boxes: Vec<BoxRecord>,
}

impl<R: Real> List<'_, R> {
    /// Everything but the planes: what is in no part stands outside of all volumes.
    fn push_all(&mut self) {
        let parts = &self.flat.parts;
        let mut loose = vec![true; self.flat.primitives() as usize];
        let planes = self.flat.first_plane() as usize..self.flat.first_disk() as usize;
        loose[planes].fill(false);
        for ids in parts.iter().flat_map(|part| &part.ids) {
            loose[ids.start as usize..ids.end as usize].fill(false);
        }
        let loose: Vec<u32> = (0..)
            .zip(&loose)
            .filter(|(_, l)| **l)
            .map(|(id, _)| id)
            .collect();
        self.push_runs(&loose);
        for &part in self.nesting.outermost() {
            self.push_part(part);
        }
    }

    /// A part: its volume, its own primitives, the parts in it.
    fn push_part(&mut self, index: usize) {
        let part = &self.flat.parts[index];
        let own: Vec<u32> = part.ids.iter().cloned().flatten().collect();
        // A mesh has no volume of its own in the scene's words.
        if part.is_mesh && self.listing == Listing::Given {
            return self.push_runs(&own);
        }
        let all: Vec<u32> = self
            .nesting
            .with_all_in(index)
            .flat_map(|part| self.flat.parts[part].ids.iter().cloned().flatten())
            .collect();
        if all.is_empty() {
            return;
        }
        let start = self.push_volume(&all, part.given);
        match self.listing {
            Listing::Given => self.push_runs(&own),
            Listing::Balls(levels) | Listing::Boxes(levels) => {
                self.push_levels(own, levels.saturating_sub(1));
            }
        }
        for &child in self.nesting.children(index) {
            self.push_part(child);
        }
        self.entries[start].skip = self.entries.len() as u32;
    }

    /// Primitives in so many levels of volumes.
    fn push_levels(&mut self, mut ids: Vec<u32>, levels: u32) {
        if levels == 0 || ids.len() <= BRANCHES {
            return self.push_runs(&ids);
        }
        let (left, right) = self.held.halves(&mut ids);
        for half in [left, right] {
            let (left, right) = self.held.halves(half);
            for quarter in [left, right] {
                let start = self.push_volume(quarter, None);
                self.push_levels(quarter.to_vec(), levels - 1);
                self.entries[start].skip = self.entries.len() as u32;
            }
        }
    }

    /// Primitives, as runs of one kind each; the first belongs to the volume that was
    /// just begun, if one was.
    fn push_runs(&mut self, ids: &[u32]) {
        let mut ids = ids.to_vec();
        ids.sort_unstable();
        for run in ids.chunk_by(|&a, &b| self.flat.kind_of(a).0 == self.flat.kind_of(b).0) {
            if self.entries.last().is_none_or(|last| last.count > 0) {
                let next = self.entries.len() as u32 + 1;
                self.push_entry(EVERYTHING, next);
            }
            if let Some(last) = self.entries.last_mut() {
                last.first = self.ids.len() as u32;
                last.count = run.len() as u32;
            }
            self.ids.extend(run);
        }
    }

    /// The volume around primitives, and its place in the list.
    fn push_volume(&mut self, ids: &[u32], given: Option<GivenBound<R>>) -> usize {
        let ball = match (self.listing, given) {
            (Listing::Given, Some(GivenBound::Box(given))) => {
                let needed = self.held.box_of(ids);
                return self.push_box(self.held.settle_box(given, needed));
            }
            (Listing::Boxes(_), _) => return self.push_box(self.held.box_of(ids)),
            (Listing::Given, Some(GivenBound::Ball(given))) => self.held.settle_ball(given, ids),
            _ => self.held.ball_of(ids),
        };
        self.balls.push(ball);
        self.push_entry(self.balls.len() as u32 - 1, 0)
    }

    fn push_box(&mut self, bounds: BoxRecord) -> usize {
        self.boxes.push(bounds);
        self.push_entry(BOX | (self.boxes.len() as u32 - 1), 0)
    }

    fn push_entry(&mut self, bound: u32, skip: u32) -> usize {
        self.entries.push(Volume {
            bound,
            first: 0,
            count: 0,
            skip,
        });
        self.entries.len() - 1
    }
}
