//! Local arrays without their zeros.
//!
//! WGSL says that every variable begins as zero, so naga has each invocation clear
//! the traversal's stack: 512 bytes a ray, a third of lavapipe's time for a ray that
//! misses everything. An element of that stack is written before it is read.

use std::collections::{HashMap, HashSet};

use super::spirv::{HEADER, instructions};

const OP_TYPE_ARRAY: u32 = 28;
const OP_TYPE_POINTER: u32 = 32;
const OP_VARIABLE: u32 = 59;
const FUNCTION: u32 = 7;

/// The words of a variable without an initializer.
const BARE: usize = 4;

/// The module with no initializer on arrays that are local to a function.
pub(super) fn leave_arrays_unset(spirv: &[u32]) -> Vec<u32> {
    let mut arrays = HashSet::new();
    let mut pointees = HashMap::new();
    let mut lean = spirv[..HEADER].to_vec();
    for (_, opcode, words) in instructions(spirv) {
        match opcode {
            OP_TYPE_ARRAY => {
                arrays.insert(words[1]);
            }
            OP_TYPE_POINTER => {
                pointees.insert(words[1], words[3]);
            }
            _ => {}
        }
        let array = |pointer| pointees.get(pointer).is_some_and(|to| arrays.contains(to));
        if opcode == OP_VARIABLE && words[3] == FUNCTION && array(&words[1]) {
            lean.push((BARE as u32) << 16 | OP_VARIABLE);
            lean.extend_from_slice(&words[1..BARE]);
        } else {
            lean.extend_from_slice(words);
        }
    }
    lean
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::program::{Program, Source};

    const SHADER: &str = "
        @group(0) @binding(0) var<storage, read_write> x: array<f32>;
        @compute @workgroup_size(1) fn main() {
            var stack: array<f32, 4>;
            var sum: f32;
            stack[u32(x[1])] = x[0];
            sum += stack[u32(x[2])];
            x[0] = sum;
        }";

    /// The words of each local variable.
    fn variables(spirv: &[u32]) -> Vec<usize> {
        instructions(spirv)
            .filter(|(_, opcode, words)| *opcode == OP_VARIABLE && words[3] == FUNCTION)
            .map(|(_, _, words)| words.len())
            .collect()
    }

    #[test]
    fn arrays_are_left_unset_and_numbers_are_not() {
        let program = Program::build(&[Source::new("test", SHADER)]).unwrap();
        let mut found = variables(&program.spirv);
        found.sort_unstable();
        assert_eq!(found, [BARE, BARE + 1]);
    }
}
