//! The numbers of a value, one by one.

use naga::{Expression, Handle, Scalar, TypeInner, VectorSize};

use super::block::Lowering;

/// How many numbers a value of f64 holds: one, or a vector of them.
pub(super) type Shape = Option<VectorSize>;

/// The shape of what holds f64 and nothing else.
pub(super) fn shape(inner: &TypeInner) -> Option<Shape> {
    match *inner {
        TypeInner::Scalar(Scalar::F64) => Some(None),
        TypeInner::Vector { size, scalar } if scalar == Scalar::F64 => Some(Some(size)),
        _ => None,
    }
}

impl Lowering<'_> {
    /// Does something to each number of some operands: of a vector's in turn, and a
    /// scalar's every time.
    pub(super) fn each(
        &mut self,
        operands: &[Handle<Expression>],
        mut work: impl FnMut(&mut Self, &[Handle<Expression>]) -> Result<Handle<Expression>, String>,
    ) -> Result<Handle<Expression>, String> {
        let vector = operands.iter().find_map(|&old| self.size(old));
        let mut numbers = Vec::new();
        for index in 0..vector.map_or(1, |size| size as u32) {
            let parts = operands.iter().map(|&old| self.component(old, index));
            let parts = parts.collect::<Result<Vec<_>, _>>()?;
            numbers.push(work(self, &parts)?);
        }
        Ok(match vector {
            Some(_) => self.matrix(numbers),
            None => numbers[0],
        })
    }

    /// Number `index` of a vector, or the number itself.
    pub(super) fn component(
        &mut self,
        old: Handle<Expression>,
        index: u32,
    ) -> Result<Handle<Expression>, String> {
        let base = self.value(old)?;
        Ok(match self.size(old) {
            Some(_) => self.append(Expression::AccessIndex { base, index }),
            None => base,
        })
    }

    /// The number with these two parts.
    pub(super) fn number(&mut self, components: Vec<Handle<Expression>>) -> Handle<Expression> {
        let ty = self.names.two_float;
        self.append(Expression::Compose { ty, components })
    }

    /// The vector of these numbers.
    pub(super) fn matrix(&mut self, components: Vec<Handle<Expression>>) -> Handle<Expression> {
        let ty = self.names.matrices[components.len() - 2];
        self.append(Expression::Compose { ty, components })
    }

    pub(super) fn type_of(&self, old: Handle<Expression>) -> &TypeInner {
        self.types[old.index()]
    }

    pub(super) fn size(&self, old: Handle<Expression>) -> Option<VectorSize> {
        match *self.type_of(old) {
            TypeInner::Vector { size, .. } => Some(size),
            _ => None,
        }
    }

    pub(super) fn is_real(&self, old: Handle<Expression>) -> bool {
        shape(self.type_of(old)).is_some()
    }

    pub(super) fn refuse<T>(&self, old: Handle<Expression>) -> Result<T, String> {
        let (expression, ty) = (&self.before[old], self.type_of(old));
        Err(format!("not in two f32: {expression:?}, {ty:?}"))
    }
}
