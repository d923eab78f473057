//! A function's statements, in two f32.
//!
//! Operations become calls, and calls are statements. So the expressions that one
//! statement of the module evaluated are evaluated in portions, between the calls.

use std::collections::HashMap;

use naga::valid::FunctionInfo;
use naga::{Arena, Block, Expression, Function, Handle, Module, Span, Statement, SwitchCase};
use naga::{Type, TypeInner};

use super::{Names, signature};

/// Where each expression has gone.
pub(super) type Moved = HashMap<Handle<Expression>, Handle<Expression>>;

/// A function, or the module's constants, as far as rewritten.
pub(super) struct Lowering<'a> {
    pub(super) module: &'a Module,
    pub(super) names: &'a Names,
    /// The expressions as they were, and the types that they had.
    pub(super) before: &'a Arena<Expression>,
    pub(super) types: Vec<&'a TypeInner>,
    expressions: Arena<Expression>,
    moved: Moved,
    block: Block,
    /// Expressions from here on are not yet evaluated by a statement.
    pending: Option<usize>,
}

impl<'a> Lowering<'a> {
    /// A function, in two f32.
    pub(super) fn of_function(
        module: &'a Module,
        names: &'a Names,
        function: &'a Function,
        info: &'a FunctionInfo,
    ) -> Result<Function, String> {
        let types = |handle: Handle<Expression>| info[handle].ty.inner_with(&module.types);
        let mut lowering = Self::new(module, names, &function.expressions, types);
        for (handle, expression) in function.expressions.iter() {
            if expression.needs_pre_emit() {
                lowering.lower(handle)?;
            }
        }
        let mut local_variables = function.local_variables.clone();
        for (_, variable) in local_variables.iter_mut() {
            variable.init = match variable.init {
                Some(init) => Some(lowering.constant(init)?),
                None => None,
            };
        }
        lowering.evaluate();
        let mut body = std::mem::take(&mut lowering.block);
        body.extend_block(lowering.lower_block(&function.body)?);
        Ok(Function {
            local_variables,
            expressions: lowering.expressions,
            body,
            ..signature(function)
        })
    }

    /// The module's constant expressions, in two f32, and where each has gone.
    pub(super) fn of_constants(
        module: &'a Module,
        names: &'a Names,
        constants: &'a Arena<Expression>,
        types: impl Fn(Handle<Expression>) -> &'a TypeInner,
    ) -> Result<(Arena<Expression>, Moved), String> {
        let mut lowering = Self::new(module, names, constants, types);
        for (handle, _) in constants.iter() {
            lowering.lower(handle)?;
        }
        let taken_apart = lowering
            .expressions
            .iter()
            .find(|(_, expression)| matches!(expression, Expression::AccessIndex { .. }));
        match taken_apart {
            Some(_) => Err("a constant made of vectors of f64".to_string()),
            None => Ok((lowering.expressions, lowering.moved)),
        }
    }

    fn new(
        module: &'a Module,
        names: &'a Names,
        before: &'a Arena<Expression>,
        types: impl Fn(Handle<Expression>) -> &'a TypeInner,
    ) -> Self {
        Self {
            module,
            names,
            before,
            types: before.iter().map(|(handle, _)| types(handle)).collect(),
            expressions: Arena::new(),
            moved: Moved::new(),
            block: Block::new(),
            pending: None,
        }
    }

    /// Where an expression has gone.
    pub(super) fn value(&self, old: Handle<Expression>) -> Result<Handle<Expression>, String> {
        let moved = self.moved.get(&old).copied();
        moved.ok_or_else(|| format!("not evaluated before its use: {:?}", self.before[old]))
    }

    /// Adds an expression.
    pub(super) fn append(&mut self, expression: Expression) -> Handle<Expression> {
        let is_result = matches!(
            expression,
            Expression::CallResult(_) | Expression::AtomicResult { .. }
        );
        if expression.needs_pre_emit() || is_result {
            self.evaluate();
        } else {
            self.pending.get_or_insert(self.expressions.len());
        }
        self.expressions.append(expression, Span::UNDEFINED)
    }

    /// Calls a function of `two_float.wgsl`.
    pub(super) fn call(
        &mut self,
        name: &'static str,
        arguments: &[Handle<Expression>],
    ) -> Result<Handle<Expression>, String> {
        let function = self.names.helpers.get(name);
        let function = *function.ok_or_else(|| format!("no function `{name}`"))?;
        let result = self.append(Expression::CallResult(function));
        self.push(Statement::Call {
            function,
            arguments: arguments.to_vec(),
            result: Some(result),
        });
        Ok(result)
    }

    pub(super) fn ty(&self, handle: Handle<Type>) -> &'a TypeInner {
        &self.module.types[handle].inner
    }

    fn push(&mut self, statement: Statement) {
        self.block.push(statement, Span::UNDEFINED);
    }

    /// Has a statement evaluate what is pending.
    fn evaluate(&mut self) {
        if let Some(start) = self.pending.take() {
            let range = self.expressions.range_from(start);
            self.push(Statement::Emit(range));
        }
    }

    /// Rewrites an expression, unless that is done.
    fn lower(&mut self, old: Handle<Expression>) -> Result<(), String> {
        if !self.moved.contains_key(&old) {
            let new = self.expression(old)?;
            self.moved.insert(old, new);
        }
        Ok(())
    }

    /// A variable's first value, which no statement evaluates.
    fn constant(&mut self, old: Handle<Expression>) -> Result<Handle<Expression>, String> {
        match &self.before[old] {
            Expression::Compose { components, .. } => {
                for component in components {
                    self.constant(*component)?;
                }
            }
            Expression::Splat { value, .. } => {
                self.constant(*value)?;
            }
            _ => {}
        }
        self.lower(old)?;
        self.value(old)
    }

    fn lower_block(&mut self, block: &Block) -> Result<Block, String> {
        let outer = std::mem::take(&mut self.block);
        for statement in block {
            if let Statement::Emit(range) = statement {
                for old in range.clone() {
                    self.lower(old)?;
                }
            } else {
                self.evaluate();
                let lowered = self.statement(statement)?;
                self.push(lowered);
            }
        }
        self.evaluate();
        Ok(std::mem::replace(&mut self.block, outer))
    }

    fn statement(&mut self, statement: &Statement) -> Result<Statement, String> {
        Ok(match statement {
            Statement::Block(block) => Statement::Block(self.lower_block(block)?),
            Statement::If {
                condition,
                accept,
                reject,
            } => Statement::If {
                condition: self.value(*condition)?,
                accept: self.lower_block(accept)?,
                reject: self.lower_block(reject)?,
            },
            Statement::Switch { selector, cases } => Statement::Switch {
                selector: self.value(*selector)?,
                cases: cases
                    .iter()
                    .map(|case| {
                        Ok(SwitchCase {
                            value: case.value,
                            body: self.lower_block(&case.body)?,
                            fall_through: case.fall_through,
                        })
                    })
                    .collect::<Result<_, String>>()?,
            },
            Statement::Loop {
                body,
                continuing,
                break_if,
            } => Statement::Loop {
                body: self.lower_block(body)?,
                continuing: self.lower_block(continuing)?,
                break_if: break_if.map(|old| self.value(old)).transpose()?,
            },
            Statement::Return { value } => Statement::Return {
                value: value.map(|old| self.value(old)).transpose()?,
            },
            Statement::Store { pointer, value } => Statement::Store {
                pointer: self.value(*pointer)?,
                value: self.value(*value)?,
            },
            Statement::Call {
                function,
                arguments,
                result,
            } => {
                let function = self.names.functions[function];
                let arguments = arguments.iter().map(|old| self.value(*old));
                Statement::Call {
                    function,
                    arguments: arguments.collect::<Result<_, _>>()?,
                    result: result.map(|old| {
                        let new = self.append(Expression::CallResult(function));
                        self.moved.insert(old, new);
                        new
                    }),
                }
            }
            Statement::Break
            | Statement::Continue
            | Statement::Kill
            | Statement::ControlBarrier(_)
            | Statement::MemoryBarrier(_) => statement.clone(),
            _ => return Err(format!("not in two f32: {statement:?}")),
        })
    }
}
