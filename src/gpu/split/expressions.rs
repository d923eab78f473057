//! An expression, in two f32.

use naga::UnaryOperator;
use naga::{BinaryOperator, Expression, Handle, Literal, MathFunction, Scalar};

use super::block::Lowering;
use super::numbers::shape;

impl Lowering<'_> {
    /// The rewritten form of an expression whose operands are rewritten.
    pub(super) fn expression(
        &mut self,
        old: Handle<Expression>,
    ) -> Result<Handle<Expression>, String> {
        let expression = &self.before[old];
        match *expression {
            Expression::Literal(Literal::F64(value)) => self.literal(value),
            Expression::Compose { ty, ref components } if shape(self.ty(ty)).is_some() => {
                self.compose(components)
            }
            Expression::Splat { size, value } if self.is_real(value) => {
                let value = self.value(value)?;
                Ok(self.matrix(vec![value; size as usize]))
            }
            Expression::Swizzle {
                size,
                vector,
                pattern,
            } if self.is_real(vector) => {
                let base = self.value(vector)?;
                let columns = pattern[..size as usize].iter().map(|component| {
                    let index = *component as u32;
                    self.append(Expression::AccessIndex { base, index })
                });
                let columns = columns.collect();
                Ok(self.matrix(columns))
            }
            Expression::Unary {
                op: UnaryOperator::Negate,
                expr,
            } if self.is_real(expr) => self.each(&[expr], |this, parts| {
                let (op, expr) = (UnaryOperator::Negate, parts[0]);
                Ok(this.append(Expression::Unary { op, expr }))
            }),
            Expression::Binary { op, left, right } if self.is_real(left) || self.is_real(right) => {
                self.binary(op, left, right)
            }
            Expression::Select {
                condition,
                accept,
                reject,
            } if self.is_real(accept) => self.select(condition, accept, reject),
            Expression::Math { fun, arg, arg1, .. } if self.is_real(arg) => {
                let name = match fun {
                    MathFunction::Abs => "absolute_two",
                    MathFunction::Sqrt => "square_root_two",
                    MathFunction::Min => "least_two",
                    MathFunction::Max => "greatest_two",
                    _ => return self.refuse(old),
                };
                let arguments: Vec<_> = [Some(arg), arg1].into_iter().flatten().collect();
                self.each(&arguments, |this, parts| this.call(name, parts))
            }
            Expression::As { expr, convert, .. } if self.is_real(expr) || self.is_real(old) => {
                if convert.is_none() {
                    return self.refuse(old);
                }
                self.convert(old, expr)
            }
            _ => self.unchanged(old),
        }
    }

    /// An expression in which nothing changes but where its operands are.
    fn unchanged(&mut self, old: Handle<Expression>) -> Result<Handle<Expression>, String> {
        let mut expression = self.before[old].clone();
        let operands: Vec<&mut Handle<Expression>> = match &mut expression {
            Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::Override(_)
            | Expression::ZeroValue(_)
            | Expression::FunctionArgument(_)
            | Expression::GlobalVariable(_)
            | Expression::LocalVariable(_) => Vec::new(),
            Expression::Compose { components, .. } => components.iter_mut().collect(),
            Expression::Access { base, index } => vec![base, index],
            Expression::AccessIndex { base, .. } => vec![base],
            Expression::Load { pointer } => vec![pointer],
            Expression::ArrayLength(array) => vec![array],
            Expression::ImageLoad {
                image,
                coordinate,
                array_index,
                sample,
                level,
            } => [Some(image), Some(coordinate)]
                .into_iter()
                .chain([array_index.as_mut(), sample.as_mut(), level.as_mut()])
                .flatten()
                .collect(),
            Expression::Splat { value, .. } => vec![value],
            Expression::Swizzle { vector, .. } => vec![vector],
            Expression::Unary { expr, .. }
            | Expression::As { expr, .. }
            | Expression::Relational { argument: expr, .. } => {
                if self.is_real(*expr) {
                    return self.refuse(old);
                }
                vec![expr]
            }
            Expression::Binary { left, right, .. } => vec![left, right],
            Expression::Select {
                condition,
                accept,
                reject,
            } => vec![condition, accept, reject],
            Expression::Math {
                arg,
                arg1,
                arg2,
                arg3,
                ..
            } => [Some(arg), arg1.as_mut(), arg2.as_mut(), arg3.as_mut()]
                .into_iter()
                .flatten()
                .collect(),
            _ => return self.refuse(old),
        };
        for operand in operands {
            *operand = self.value(*operand)?;
        }
        Ok(self.append(expression))
    }

    /// As the twin's `from_f64`.
    fn literal(&mut self, value: f64) -> Result<Handle<Expression>, String> {
        let high = value as f32;
        let low = (value - f64::from(high)) as f32;
        if !high.is_finite() {
            return Err(format!("no f32 is near {value:e}"));
        }
        let components = [high, low]
            .map(|part| self.append(Expression::Literal(Literal::F32(part))))
            .to_vec();
        Ok(self.number(components))
    }

    /// A vector of numbers and of vectors.
    fn compose(&mut self, parts: &[Handle<Expression>]) -> Result<Handle<Expression>, String> {
        let mut columns = Vec::new();
        for &part in parts {
            let count = shape(self.type_of(part)).flatten().map_or(1, |n| n as u32);
            for index in 0..count {
                columns.push(self.component(part, index)?);
            }
        }
        Ok(self.matrix(columns))
    }

    fn binary(
        &mut self,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Result<Handle<Expression>, String> {
        let name = match op {
            BinaryOperator::Add => "add_two",
            BinaryOperator::Subtract => "subtract_two",
            BinaryOperator::Multiply => "multiply_two",
            BinaryOperator::Divide => "divide_two",
            _ => return self.compare(op, left, right),
        };
        self.each(&[left, right], |this, parts| this.call(name, parts))
    }

    fn compare(
        &mut self,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Result<Handle<Expression>, String> {
        let are_numbers = [left, right].map(|side| shape(self.type_of(side)) == Some(None));
        if are_numbers != [true, true] {
            return Err(format!("not in two f32: {op:?} of vectors"));
        }
        let (a, b) = (self.value(left)?, self.value(right)?);
        match op {
            BinaryOperator::Less => self.call("less_two", &[a, b]),
            BinaryOperator::Greater => self.call("less_two", &[b, a]),
            BinaryOperator::LessEqual => self.call("less_or_equal_two", &[a, b]),
            BinaryOperator::GreaterEqual => self.call("less_or_equal_two", &[b, a]),
            BinaryOperator::Equal => self.call("equal_two", &[a, b]),
            BinaryOperator::NotEqual => {
                let (op, expr) = (UnaryOperator::LogicalNot, self.call("equal_two", &[a, b])?);
                Ok(self.append(Expression::Unary { op, expr }))
            }
            _ => Err(format!("not in two f32: {op:?}")),
        }
    }

    /// Number by number: a matrix cannot be selected.
    fn select(
        &mut self,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Result<Handle<Expression>, String> {
        self.each(&[condition, accept, reject], |this, parts| {
            Ok(this.append(Expression::Select {
                condition: parts[0],
                accept: parts[1],
                reject: parts[2],
            }))
        })
    }

    /// From and to f32, and from u32.
    fn convert(
        &mut self,
        old: Handle<Expression>,
        from: Handle<Expression>,
    ) -> Result<Handle<Expression>, String> {
        let (before, after) = (self.type_of(from).scalar(), self.type_of(old).scalar());
        let (Some(before), Some(after)) = (before, after) else {
            return self.refuse(old);
        };
        if before == after {
            return self.value(from);
        }
        match (before, after) {
            (Scalar::F32, Scalar::F64) => {
                let low = self.append(Expression::Literal(Literal::F32(0.0)));
                self.each(&[from], |this, parts| Ok(this.number(vec![parts[0], low])))
            }
            (Scalar::U32, Scalar::F64) => {
                self.each(&[from], |this, parts| this.call("two_from_u32", parts))
            }
            (Scalar::F64, Scalar::F32) => self.single(from),
            _ => self.refuse(old),
        }
    }

    /// The high parts.
    fn single(&mut self, from: Handle<Expression>) -> Result<Handle<Expression>, String> {
        let size = shape(self.type_of(from)).flatten();
        let mut components = Vec::new();
        for index in 0..size.map_or(1, |size| size as u32) {
            let base = self.component(from, index)?;
            components.push(self.append(Expression::AccessIndex { base, index: 0 }));
        }
        Ok(match size {
            Some(size) => {
                let ty = self.names.singles[size as usize - 2];
                self.append(Expression::Compose { ty, components })
            }
            None => components[0],
        })
    }
}
