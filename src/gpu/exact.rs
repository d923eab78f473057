//! NoContraction on every float operation of a SPIR-V module.
//!
//! Without it a driver may fuse a product with a sum, or simplify (a + b) - a
//! to b. naga does not write the decoration, so it is added here.

use super::spirv::instructions;

const OP_DECORATE: u32 = 71;
const DECORATION_NO_CONTRACTION: u32 = 42;

/// The arithmetic instructions to which NoContraction may be applied and whose
/// results can be float: OpFNegate, OpFAdd, OpFSub, OpFMul, OpFDiv, OpFRem,
/// OpFMod, OpVectorTimesScalar, OpMatrixTimesScalar, OpVectorTimesMatrix,
/// OpMatrixTimesVector, OpMatrixTimesMatrix, OpOuterProduct, OpDot.
const FLOAT_ARITHMETIC: [u32; 14] = [
    127, 129, 131, 133, 136, 140, 141, 142, 143, 144, 145, 146, 147, 148,
];

/// The first instructions of each section up to the annotations, in the order
/// of the SPIR-V specification, section 2.4: capabilities, extensions, imports,
/// memory model, entry points, execution modes, debug, annotations.
const BEFORE_TYPES: [u32; 19] = [
    17, 10, 11, 14, 15, 16, 331, 7, 3, 2, 4, 5, 6, 330, 71, 72, 73, 74, 332,
];

/// The module with NoContraction on each float operation.
pub fn forbid_contraction(spirv: &[u32]) -> Vec<u32> {
    let annotations_end = instructions(spirv)
        .find(|(_, opcode, _)| !BEFORE_TYPES.contains(opcode))
        .map_or(spirv.len(), |(start, _, _)| start);
    let decorations = instructions(spirv)
        .filter(|(_, opcode, _)| FLOAT_ARITHMETIC.contains(opcode))
        .flat_map(|(_, _, words)| {
            let result = words[2];
            [(3 << 16) | OP_DECORATE, result, DECORATION_NO_CONTRACTION]
        });
    let mut exact = spirv[..annotations_end].to_vec();
    exact.extend(decorations);
    exact.extend_from_slice(&spirv[annotations_end..]);
    exact
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::program::{Program, Source};
    use crate::gpu::spirv::HEADER;

    const SHADER: &str = "
        @group(0) @binding(0) var<storage, read_write> x: array<f32>;
        @compute @workgroup_size(1) fn main() { x[0] = -(x[1] * x[2] + x[3]) / x[4]; }";

    fn decorated(spirv: &[u32]) -> usize {
        instructions(spirv)
            .filter(|(_, opcode, words)| {
                *opcode == OP_DECORATE && words[2] == DECORATION_NO_CONTRACTION
            })
            .count()
    }

    #[test]
    fn every_float_operation_is_decorated_once() {
        let exact = Program::build(&[Source::new("test", SHADER)])
            .unwrap()
            .spirv;
        assert_eq!(decorated(&exact), 4, "product, sum, negation, quotient");
    }

    #[test]
    fn a_module_without_the_pass_has_no_decoration() {
        let exact = Program::build(&[Source::new("test", SHADER)])
            .unwrap()
            .spirv;
        let plain: Vec<u32> = exact[..HEADER]
            .iter()
            .chain(
                instructions(&exact)
                    .filter(|(_, opcode, words)| {
                        *opcode != OP_DECORATE || words[2] != DECORATION_NO_CONTRACTION
                    })
                    .flat_map(|(_, _, words)| words),
            )
            .copied()
            .collect();
        assert_eq!(decorated(&plain), 0);
        assert_eq!(forbid_contraction(&plain), exact);
    }
}
