//! Everything that can go wrong, as one enum with an exit code for each kind.

use std::path::PathBuf;

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceSpan};

/// The library's result.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// What went wrong; [`Error::exit_code`] tells a script which kind it was.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum Error {
    /// A flag or a combination of flags that makes no sense.
    #[error("{0}")]
    Usage(String),

    /// A scene file with one fault or more, each underlined where it stands.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scene(Box<SceneFaults>),

    /// A file that a scene refers to is unusable.
    #[error("{}{}: {message}", path.display(), line.map(|l| format!(":{l}")).unwrap_or_default())]
    Asset {
        /// The file, as the scene names it, joined to the scene's folder.
        path: PathBuf,
        /// The line at fault, counted from 1, where one line is.
        line: Option<usize>,
        /// What is wrong and what would be right.
        message: String,
    },

    /// No GPU adapter (hardware or software) fits what was asked for.
    #[error("no GPU adapter: {0}")]
    #[diagnostic(help(
        "install a software Vulkan driver (`apt-get install mesa-vulkan-drivers`), \
         or use `--backend cpu`"
    ))]
    NoAdapter(String),

    /// More than the device or the memory offers.
    #[error("over a limit: {0}")]
    Limit(String),

    /// The output file cannot be written; the old file, if any, is untouched.
    #[error("cannot write {}: {source}", path.display())]
    Output {
        /// The file that was to be written.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },

    /// The GPU device was lost or stopped answering.
    #[error("the device was lost: {0}")]
    DeviceLost(String),

    /// A shader did not compile: a defect of this program or of the driver.
    #[error("shader: {0}")]
    Shader(String),

    /// The user, or the program that embeds this library, asked to stop.
    #[error("interrupted")]
    Interrupted,
}

impl Error {
    /// The process exit code for this kind of error.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Usage(_) => 2,
            Error::Scene(_) | Error::Asset { .. } => 3,
            Error::NoAdapter(_) => 4,
            Error::Limit(_) => 5,
            Error::Output { .. } => 6,
            Error::DeviceLost(_) | Error::Shader(_) => 75,
            Error::Interrupted => 130,
        }
    }
}

/// All the faults of one scene file.
#[derive(Debug, thiserror::Error)]
#[error("{}: {} fault{}", source_code.name(), faults.len(), if faults.len() == 1 { "" } else { "s" })]
pub struct SceneFaults {
    /// The file's name and text, for underlining.
    pub source_code: NamedSource<String>,
    /// The faults in the order of the file.
    pub faults: Vec<Fault>,
}

/// One fault of a scene file.
#[derive(Debug, Clone, thiserror::Error)]
#[error("{message}")]
pub struct Fault {
    /// What is wrong.
    pub message: String,
    /// What would be right, if there is something to say.
    pub help: Option<String>,
    /// The bytes at fault.
    pub span: std::ops::Range<usize>,
    /// A word under the underline.
    pub label: String,
}

impl Diagnostic for Fault {
    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        self.help
            .as_ref()
            .map(|h| Box::new(h) as Box<dyn std::fmt::Display>)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let span: SourceSpan = self.span.clone().into();
        Some(Box::new(std::iter::once(LabeledSpan::new_with_span(
            Some(self.label.clone()),
            span,
        ))))
    }
}

impl Diagnostic for SceneFaults {
    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        Some(&self.source_code)
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn Diagnostic> + 'a>> {
        Some(Box::new(self.faults.iter().map(|f| f as &dyn Diagnostic)))
    }
}
