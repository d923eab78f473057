//! What happens when memory runs out.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;

use rayproof::error::Error;

/// The system's allocator; where it refuses, the process ends with a message and
/// the exit code of [`Error::Limit`], not by an abort with a stack trace. Sizes
/// are estimated before a render, so this is for what no estimate foresaw.
pub(super) struct Memory;

#[global_allocator]
static MEMORY: Memory = Memory;

#[expect(unsafe_code, reason = "the only place where a refusal can be met")]
// SAFETY: passes every call on to the system's allocator as it came, and returns
// only what that one gave.
unsafe impl GlobalAlloc for Memory {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        given(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        given(unsafe { System.realloc(old, layout, size) }, size)
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        unsafe { System.dealloc(memory, layout) }
    }
}

fn given(memory: *mut u8, bytes: usize) -> *mut u8 {
    if memory.is_null() {
        refused(bytes);
    }
    memory
}

/// Allocates nothing: the message is written piece by piece.
#[cold]
fn refused(bytes: usize) -> ! {
    let mut to = std::io::stderr();
    let _ = writeln!(
        to,
        "  × over a limit: {bytes} bytes more of memory are not to be had"
    );
    let _ = writeln!(
        to,
        "  help: take a smaller --size or fewer triangles, or allow more memory"
    );
    std::process::exit(i32::from(Error::Limit(String::new()).exit_code()))
}
