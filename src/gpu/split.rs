//! The shaders' f64 form in two f32, for devices without f64.
//!
//! WGSL has no overloading, so vector arithmetic in two f32 cannot be written as such.
//! Instead the module that naga parsed is rewritten: an f64 becomes a `vec2<f32>`, a
//! vector of n of them a matrix of n columns, and each operation a call of a function
//! of `two_float.wgsl`. Layouts stay: what took eight bytes takes eight. What cannot be
//! rewritten is an error.

mod block;
mod expressions;
mod numbers;
#[cfg(test)]
mod operation_tests;
#[cfg(test)]
mod tests;

use std::collections::{HashMap, HashSet};

use naga::valid::ModuleInfo;
use naga::{Arena, Block, Expression, Function, Handle, Module, Range, Scalar, Span};
use naga::{Statement, Type, TypeInner, VectorSize};

use block::Lowering;

/// The functions that stand for operations of f64.
const HELPERS: [&str; 12] = [
    "two_from_u32",
    "absolute_two",
    "add_two",
    "subtract_two",
    "multiply_two",
    "divide_two",
    "square_root_two",
    "less_two",
    "less_or_equal_two",
    "equal_two",
    "least_two",
    "greatest_two",
];

/// Gives the parts of a number, and is replaced: the parts are the number.
const PARTS_OF_REAL: &str = "parts_of_real";
/// Makes a number of its parts, and is replaced.
const REAL_OF_PARTS: &str = "real_of_parts";

const TWO_FLOAT: TypeInner = TypeInner::Vector {
    size: VectorSize::Bi,
    scalar: Scalar::F32,
};

/// A column for each of `size` numbers.
const fn columns(size: VectorSize) -> TypeInner {
    TypeInner::Matrix {
        columns: size,
        rows: VectorSize::Bi,
        scalar: Scalar::F32,
    }
}

/// What a function's rewriting needs to know of the module.
struct Names {
    /// Where each function has gone.
    functions: HashMap<Handle<Function>, Handle<Function>>,
    /// Where the helpers are.
    helpers: HashMap<&'static str, Handle<Function>>,
    /// A number's type.
    two_float: Handle<Type>,
    /// The types of two, three and four numbers.
    matrices: [Handle<Type>; 3],
    /// The types of two, three and four f32.
    singles: [Handle<Type>; 3],
}

/// The module without f64.
///
/// `info` is the validator's, of this same module.
///
/// # Errors
///
/// What of the module cannot be rewritten.
pub(super) fn split_reals(module: &Module, info: &ModuleInfo) -> Result<Module, String> {
    let mut split = module.clone();
    // Its keys are handles of functions, which move.
    split.doc_comments = None;
    split_types(&mut split)?;
    let mut insert = |inner| {
        split
            .types
            .insert(Type { name: None, inner }, Span::UNDEFINED)
    };
    let sizes = [VectorSize::Bi, VectorSize::Tri, VectorSize::Quad];
    let single = |size| TypeInner::Vector {
        size,
        scalar: Scalar::F32,
    };
    let mut names = Names {
        functions: HashMap::new(),
        helpers: HashMap::new(),
        two_float: insert(TWO_FLOAT),
        matrices: sizes.map(|size| insert(columns(size))),
        singles: sizes.map(|size| insert(single(size))),
    };
    split_globals(&mut split, module, info, &names)?;
    split.functions = Arena::new();
    for handle in helpers_first(module) {
        let function = &module.functions[handle];
        let lowered = match function.name.as_deref() {
            Some(PARTS_OF_REAL) => parts_of_real(function),
            Some(REAL_OF_PARTS) => real_of_parts(function, names.two_float),
            _ => Lowering::of_function(module, &names, function, &info[handle])?,
        };
        let span = module.functions.get_span(handle);
        let moved = split.functions.append(lowered, span);
        names.functions.insert(handle, moved);
        let helper = |name: &&&str| function.name.as_deref() == Some(name);
        if let Some(name) = HELPERS.iter().find(helper) {
            names.helpers.insert(name, moved);
        }
    }
    for (index, entry) in split.entry_points.iter_mut().enumerate() {
        let (function, info) = (
            &module.entry_points[index].function,
            info.get_entry_point(index),
        );
        entry.function = Lowering::of_function(module, &names, function, info)?;
    }
    Ok(split)
}

/// Replaces the types in place: no handle changes. The names keep them apart from types
/// that are there already.
fn split_types(split: &mut Module) -> Result<(), String> {
    let types: Vec<(Handle<Type>, Type)> = split
        .types
        .iter()
        .map(|(handle, ty)| (handle, ty.clone()))
        .collect();
    for (handle, mut ty) in types {
        let inner = match ty.inner {
            TypeInner::Scalar(Scalar::F64) => TWO_FLOAT,
            TypeInner::Vector { size, scalar } if scalar == Scalar::F64 => columns(size),
            TypeInner::ValuePointer {
                size: None,
                scalar: Scalar::F64,
                space,
            } => TypeInner::ValuePointer {
                size: Some(VectorSize::Bi),
                scalar: Scalar::F32,
                space,
            },
            TypeInner::Matrix { scalar, .. }
            | TypeInner::Atomic(scalar)
            | TypeInner::ValuePointer { scalar, .. }
                if scalar == Scalar::F64 =>
            {
                return Err(format!("a type in two f32: {:?}", ty.inner));
            }
            _ => continue,
        };
        ty.name = Some(format!(
            "{} {} in two f32",
            handle.index(),
            ty.name.as_deref().unwrap_or("f64")
        ));
        ty.inner = inner;
        split.types.replace(handle, ty);
    }
    Ok(())
}

/// Rewrites the values of constants and of variables.
fn split_globals(
    split: &mut Module,
    module: &Module,
    info: &ModuleInfo,
    names: &Names,
) -> Result<(), String> {
    let types = |handle: Handle<Expression>| info[handle].inner_with(&module.types);
    let (expressions, moved) =
        Lowering::of_constants(module, names, &module.global_expressions, types)?;
    for (_, constant) in split.constants.iter_mut() {
        constant.init = moved[&constant.init];
    }
    let overrides = split.overrides.iter_mut().map(|(_, each)| &mut each.init);
    let variables = split.global_variables.iter_mut();
    for init in overrides.chain(variables.map(|(_, variable)| &mut variable.init)) {
        *init = init.map(|old| moved[&old]);
    }
    split.global_expressions = expressions;
    Ok(())
}

/// All functions, callees before their callers: the helpers and what they call, then the
/// others, which now call helpers.
fn helpers_first(module: &Module) -> Vec<Handle<Function>> {
    let is_helper = |function: &Function| {
        let name = function.name.as_deref();
        name.is_some_and(|name| HELPERS.contains(&name))
    };
    let mut first = HashSet::new();
    for (handle, function) in module.functions.iter().rev() {
        if is_helper(function) || first.contains(&handle) {
            first.insert(handle);
            let results = function.expressions.iter();
            first.extend(results.filter_map(|(_, expression)| match expression {
                Expression::CallResult(callee) => Some(*callee),
                _ => None,
            }));
        }
    }
    let all = || module.functions.iter().map(|(handle, _)| handle);
    let mut ordered: Vec<_> = all().filter(|handle| first.contains(handle)).collect();
    ordered.extend(all().filter(|handle| !first.contains(handle)));
    ordered
}

/// Returns its argument.
fn parts_of_real(function: &Function) -> Function {
    let mut expressions = Arena::new();
    let value = expressions.append(Expression::FunctionArgument(0), Span::UNDEFINED);
    let body = vec![Statement::Return { value: Some(value) }];
    Function {
        expressions,
        body: Block::from_vec(body),
        ..signature(function)
    }
}

/// Returns its two arguments as one number.
fn real_of_parts(function: &Function, two_float: Handle<Type>) -> Function {
    let mut expressions = Arena::new();
    let components = [0, 1]
        .map(|index| expressions.append(Expression::FunctionArgument(index), Span::UNDEFINED))
        .to_vec();
    let ty = two_float;
    let value = expressions.append(Expression::Compose { ty, components }, Span::UNDEFINED);
    let body = vec![
        Statement::Emit(Range::new_from_bounds(value, value)),
        Statement::Return { value: Some(value) },
    ];
    Function {
        expressions,
        body: Block::from_vec(body),
        ..signature(function)
    }
}

/// The function without what it does. Its types change in place.
fn signature(function: &Function) -> Function {
    Function {
        name: function.name.clone(),
        arguments: function.arguments.clone(),
        result: function.result.clone(),
        diagnostic_filter_leaf: function.diagnostic_filter_leaf,
        ..Function::default()
    }
}
