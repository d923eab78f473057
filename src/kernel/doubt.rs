//! What is not certain of a hit, where the formulas bound their error.
//!
//! Of each shape an interval of t is known in which the ray first meets it. Another shape
//! whose interval begins before that of the nearest one ends is its rival. A ray with a
//! rival, or with a wide interval, is in doubt. `docs/numerics.md` derives the intervals.

use super::aabb::{Aabb, Slabs, clip_to_box};
use super::hit::{Hit, Meeting};
use super::real::{Real, constant};
use crate::layout::NO_HIT;
use crate::tier::Formulas;

/// The error of a ray's and a shape's numbers and of what is computed of them, in parts of
/// how far the shape reaches from the camera and from where the ray starts.
pub const ERROR: f32 = 48.0 / 16_777_216.0;

/// The width of an interval, in parts of t, from which on t is in doubt: far above what
/// ordinary rays have, which is some 2^-17, and below what a picture shows.
pub const WIDE_INTERVAL: f32 = 1.0 / 4096.0;

/// A meeting at t, as far as its formulas can tell.
pub fn certain_meeting<R: Real>(t: R) -> Meeting<R> {
    Meeting { t, low: t, high: t }
}

/// The meeting at t, which is `error` off at most: in doubt where t may be 0.
pub fn meeting_within<R: Real>(t: R, error: R) -> Meeting<R> {
    if t - error > R::ZERO {
        return Meeting {
            t,
            low: t - error,
            high: t + error,
        };
    }
    if t + error < R::ZERO {
        return certain_meeting(R::MISS);
    }
    doubtful_meeting(R::ZERO)
}

/// A meeting that may not take place, and not before `low`.
pub fn doubtful_meeting<R: Real>(low: R) -> Meeting<R> {
    let ahead = if low > R::ZERO { low } else { R::ZERO };
    Meeting {
        t: ahead,
        low: ahead,
        high: R::MISS,
    }
}

/// The meeting, as far as it is in the shape's own box.
///
/// A bound may accept a ray far from the shape, such as one in the plane of a triangle.
/// Which of those are tested would depend on the tree, and with them whether the ray is in
/// doubt. No hit is lost: in f64 too, it counts only in the same box.
///
/// With it, no tree matters to doubt. Let X be the certain meeting with the least t, and r
/// the one with the least `low` of those others that begin before X ends. A search skips r
/// only for a hit that ends before r begins; that one would begin sooner than r, and before X
/// ends. So r is tested, and is a rival or was the hit before it became one.
pub fn meeting_in_box<R: Real>(slabs: Slabs, own: Aabb, meeting: Meeting<R>) -> Meeting<R> {
    let interval = clip_to_box(slabs, own.low, own.high);
    if interval.enter > interval.exit {
        return certain_meeting(R::MISS);
    }
    let enter = constant(interval.enter);
    let low = if meeting.low < enter {
        enter
    } else {
        meeting.low
    };
    let t = if meeting.t < low { low } else { meeting.t };
    let high = if meeting.high < t { t } else { meeting.high };
    Meeting { t, low, high }
}

/// Whether a meeting may be the closest. A tie is for [`keep_nearer`] to settle, by the
/// ids, which are read only now.
#[inline]
pub fn may_be_closest<R: Real>(hit: Hit<R>, meeting: Meeting<R>) -> bool {
    if R::FORMULAS == Formulas::Bounded {
        return meeting.low <= hit.high && meeting.low < R::MISS;
    }
    meeting.t <= hit.t && meeting.t < R::MISS
}

/// Keeps a hit if it is nearer. Of two hits at the same t the lower id stays, so the
/// order of the tests does not matter.
#[inline]
pub fn keep_nearer<R: Real>(hit: &mut Hit<R>, meeting: Meeting<R>, id: u32, row: u32) {
    if R::FORMULAS == Formulas::Bounded {
        return keep_interval(hit, meeting, id, row);
    }
    if meeting.t < hit.t || (meeting.t == hit.t && id < hit.id) {
        hit.t = meeting.t;
        hit.id = id;
        hit.row = row;
    }
}

/// Keeps a hit if it is certain and nearer; else, or what was kept before, it is a rival.
#[inline]
fn keep_interval<R: Real>(hit: &mut Hit<R>, meeting: Meeting<R>, id: u32, row: u32) {
    let nearer = meeting.high < R::MISS && meeting.t < hit.t;
    let other = if nearer { hit.low } else { meeting.low };
    if other < hit.rival {
        hit.rival = other;
    }
    if nearer {
        hit.t = meeting.t;
        hit.low = meeting.low;
        hit.high = meeting.high;
        hit.id = id;
        hit.row = row;
    }
}

/// The t after which nothing can be the closest.
#[inline]
pub fn limit_of<R: Real>(hit: Hit<R>) -> R {
    if R::FORMULAS == Formulas::Bounded {
        hit.high
    } else {
        hit.t
    }
}

/// Whether the hit, or that there is none, is in doubt.
pub fn is_in_doubt<R: Real>(hit: Hit<R>) -> bool {
    let rivalled = hit.rival <= hit.high && hit.rival < R::MISS;
    let wide = hit.id != NO_HIT && hit.high - hit.low > hit.t * constant(WIDE_INTERVAL);
    rivalled || wide
}
