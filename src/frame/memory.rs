//! Sizes are checked before memory is taken: an allocation that the system
//! grants and cannot serve ends the process without a word.

use std::fs;

use crate::{Error, Result};

/// The number of pixels of a picture, once the memory for it is known to be
/// there.
///
/// # Errors
/// [`Error::Limit`] with the bytes needed and the bytes there are.
pub(super) fn reserve_pixels(width: u32, height: u32, bytes_per_pixel: u64) -> Result<usize> {
    let pixels = u64::from(width) * u64::from(height);
    let needed = u128::from(pixels) * u128::from(bytes_per_pixel);
    let available = available_bytes();
    if needed > u128::from(available) {
        return Err(Error::Limit(format!(
            "a picture of {width} x {height} pixels takes {needed} bytes of memory, \
             and {available} are available"
        )));
    }
    usize::try_from(pixels)
        .map_err(|_| Error::Limit(format!("{width} x {height} pixels cannot be addressed")))
}

/// `count` copies of `value`.
///
/// # Errors
/// [`Error::Limit`] where the allocator refuses.
pub(super) fn filled<T: Clone>(count: usize, value: T) -> Result<Vec<T>> {
    let mut values = Vec::new();
    values.try_reserve_exact(count).map_err(|_| {
        Error::Limit(format!(
            "{count} values of {} bytes do not fit in memory",
            size_of::<T>()
        ))
    })?;
    values.resize(count, value);
    Ok(values)
}

/// Bytes that can be taken without swapping, being refused or killed: the least
/// of what the kernel, the control group and the process's own limit say. Where
/// nothing is known, what one allocation can hold.
fn available_bytes() -> u64 {
    [system_bytes(), group_bytes(), process_bytes()]
        .into_iter()
        .flatten()
        .fold(isize::MAX as u64, u64::min)
}

/// Linux: `MemAvailable` of proc(5).
fn system_bytes() -> Option<u64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let kib = text
        .lines()
        .find_map(|line| line.strip_prefix("MemAvailable:"))?
        .trim()
        .strip_suffix(" kB")?;
    kib.parse::<u64>().ok()?.checked_mul(1024)
}

/// Linux control groups, version 2, as a container sees its own: the limit less
/// what is in use.
fn group_bytes() -> Option<u64> {
    let read = |name| fs::read_to_string(format!("/sys/fs/cgroup/{name}")).ok();
    // No limit is `max`, which is no number.
    let limit = read("memory.max")?.trim().parse().ok()?;
    let used = read("memory.current")?.trim().parse().ok()?;
    Some(group_available(limit, used, &read("memory.stat")?))
}

/// A group's use counts the files that the kernel keeps in memory, which it gives
/// up when the memory is wanted: after a build that is most of it.
fn group_available(limit: u64, used: u64, stat: &str) -> u64 {
    let cached = stat
        .lines()
        .filter_map(|line| line.split_once(' '))
        .filter(|(name, _)| ["active_file", "inactive_file"].contains(name))
        .filter_map(|(_, bytes)| bytes.trim().parse::<u64>().ok())
        .fold(0, u64::saturating_add);
    limit.saturating_sub(used.saturating_sub(cached))
}

/// Linux: the limit on the address space (`ulimit -v`) less what is in use.
fn process_bytes() -> Option<u64> {
    let number = |file: &str, line: &str| -> Option<u64> {
        let text = fs::read_to_string(file).ok()?;
        let rest = text.lines().find_map(|l| l.strip_prefix(line))?;
        // `unlimited` is no number.
        rest.split_whitespace().next()?.parse().ok()
    };
    let limit = number("/proc/self/limits", "Max address space")?;
    let in_use = number("/proc/self/status", "VmSize:")?.checked_mul(1024)?;
    Some(limit.saturating_sub(in_use))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_is_exactly_what_is_available() {
        assert_eq!(reserve_pixels(1000, 1000, 44).unwrap(), 1_000_000);
        let error = reserve_pixels(u32::MAX, u32::MAX, u64::MAX).unwrap_err();
        assert!(matches!(error, Error::Limit(_)), "{error}");
    }

    #[test]
    fn cached_files_of_a_group_are_available() {
        let stat = "anon 100\nfile 700\ninactive_file 500\nactive_file 200\n";
        assert_eq!(group_available(1000, 900, stat), 800);
        assert_eq!(group_available(1000, 900, "anon 900\n"), 100);
        assert_eq!(group_available(1000, 1200, "anon 1200\n"), 0);
    }

    #[test]
    fn a_refused_allocation_is_an_error() {
        let error = filled(usize::MAX / 8, 0_u64).unwrap_err();
        assert!(matches!(error, Error::Limit(_)), "{error}");
        assert_eq!(filled(3, 7_u8).unwrap(), [7, 7, 7]);
    }
}
