//! The words of a SPIR-V module.

/// Words before the first instruction.
pub(super) const HEADER: usize = 5;

/// Start, opcode and words of each instruction.
pub(super) fn instructions(spirv: &[u32]) -> impl Iterator<Item = (usize, u32, &[u32])> {
    let mut start = HEADER;
    std::iter::from_fn(move || {
        let first = *spirv.get(start)?;
        let (count, opcode) = ((first >> 16) as usize, first & 0xffff);
        let words = spirv.get(start..start + count.max(1))?;
        let at = start;
        start += count.max(1);
        Some((at, opcode, words))
    })
}
