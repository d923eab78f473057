//! The layers of a frame, by name.

use std::fmt;
use std::str::FromStr;

use crate::Error;

/// What a pixel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Layer {
    /// Linear light.
    Color,
    /// Distance along the ray.
    Depth,
    /// Unit normal in world space.
    Normal,
    /// Hit point relative to the camera.
    Position,
    /// Primitive id.
    Id,
}

impl Layer {
    /// Every layer, in the order of [`super::Frame`]'s fields.
    pub const ALL: [Self; 5] = [
        Self::Color,
        Self::Depth,
        Self::Normal,
        Self::Position,
        Self::Id,
    ];

    /// The name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Color => "color",
            Self::Depth => "depth",
            Self::Normal => "normal",
            Self::Position => "position",
            Self::Id => "id",
        }
    }
}

impl fmt::Display for Layer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Layer {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        Self::ALL
            .into_iter()
            .find(|layer| layer.name() == name)
            .ok_or_else(|| {
                let names = Self::ALL.map(Self::name).join(", ");
                Error::Usage(format!("no layer is named '{name}': use one of {names}"))
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for layer in Layer::ALL {
            assert_eq!(layer.to_string().parse::<Layer>().unwrap(), layer);
        }
    }

    #[test]
    fn an_unknown_name_lists_the_known_ones() {
        let message = "Depth".parse::<Layer>().unwrap_err().to_string();
        assert_eq!(
            message,
            "no layer is named 'Depth': use one of color, depth, normal, position, id"
        );
    }
}
