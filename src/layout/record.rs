//! How records are declared: with their fields' names and places, for the test that holds
//! them to the shaders' structs.

/// A record that a WGSL struct mirrors.
pub trait Record {
    /// The WGSL struct's name.
    const NAME: &'static str;
    /// Name and byte offset of each field that is not padding.
    fn fields() -> Vec<(&'static str, usize)>;
    /// Bytes from one element of an array to the next.
    fn stride() -> usize;
}

macro_rules! records {
    ($($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $ty:ty,)* })*) => {$(
        $(#[$doc])*
        #[repr(C)]
        #[derive(Debug, Clone, Copy, Default, PartialEq, Pod, Zeroable)]
        pub struct $name { $($(#[$field_doc])* pub $field: $ty,)* }

        impl Record for $name {
            const NAME: &'static str = stringify!($name);
            fn fields() -> Vec<(&'static str, usize)> {
                vec![$((stringify!($field), std::mem::offset_of!($name, $field)),)*]
                    .into_iter().filter(|(field, _)| !field.starts_with("padding")).collect()
            }
            fn stride() -> usize { size_of::<Self>() }
        }
    )*};
}

macro_rules! real_records {
    ($($(#[$doc:meta])* $wgsl:literal $name:ident { $($(#[$field_doc:meta])* $field:ident: $ty:ty,)* })*) => {$(
        $(#[$doc])*
        #[repr(C)]
        #[derive(Debug, Clone, Copy, Default, PartialEq)]
        pub struct $name<R> { $($(#[$field_doc])* pub $field: $ty,)* }

        #[expect(unsafe_code, reason = "every field is an R or an array of R: no padding")]
        // SAFETY: `Real` is `Pod`, and fields of one type leave no gaps under repr(C).
        unsafe impl<R: Real> Pod for $name<R> {}
        #[expect(unsafe_code, reason = "every field is an R or an array of R")]
        // SAFETY: `Real` is `Zeroable`.
        unsafe impl<R: Real> Zeroable for $name<R> {}

        impl<R: Real> Record for $name<R> {
            const NAME: &'static str = $wgsl;
            fn fields() -> Vec<(&'static str, usize)> {
                vec![$((stringify!($field), std::mem::offset_of!($name<R>, $field)),)*]
                    .into_iter().filter(|(field, _)| !field.starts_with("padding")).collect()
            }
            fn stride() -> usize { size_of::<Self>() }
        }
    )*};
}
