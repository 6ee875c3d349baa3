//! Names of OpenGL 1.x (1.0 to 1.5, with ARB_multitexture and the extensions used with emboss).
//! They are the commands that `GL_NV_texgen_emboss` doesn't change: [`super::nv`] passes them on,
//! and can tell them from typing errors.
//!
//! Braces hold alternatives, as the specification writes its commands: `Light{|f|i}{|v}`. An empty
//! alternative is the command without that letter.

use std::collections::BTreeSet;
use std::sync::LazyLock;

/// Commands, without `gl`.
const COMMANDS: &[&str] = &[
    // 1.0 and 1.1
    "Accum",
    "AlphaFunc",
    "AreTexturesResident",
    "ArrayElement",
    "Begin",
    "BindTexture",
    "Bitmap",
    "BlendFunc",
    "CallList{|s}",
    "Clear{|Accum|Color|Depth|Index|Stencil}",
    "ClipPlane",
    "Color{|3|4}{|b|d|f|i|s|ub|ui|us}{|v}",
    "ColorMask",
    "ColorMaterial",
    "ColorPointer",
    "CopyPixels",
    "CopyTexImage{1D|2D}",
    "CopyTexSubImage{1D|2D|3D}",
    "CullFace",
    "DeleteLists",
    "DeleteTextures",
    "DepthFunc",
    "DepthMask",
    "DepthRange",
    "{Dis|En}ableClientState",
    "DrawArrays",
    "DrawBuffer",
    "DrawElements",
    "DrawPixels",
    "EdgeFlag{|v|Pointer}",
    "End",
    "EndList",
    "EvalCoord{1|2}{|d|f}{|v}",
    "EvalMesh{1|2}",
    "EvalPoint{1|2}",
    "FeedbackBuffer",
    "Finish",
    "Flush",
    "Fog{|f|i}{|v}",
    "FrontFace",
    "Frustum",
    "GenLists",
    "GenTextures",
    "Get{|Booleanv|Doublev|Floatv|Integerv|Pointerv}",
    "GetClipPlane",
    "GetError",
    "GetLight{|fv|iv}",
    "GetMap{|dv|fv|iv}",
    "GetMaterial{|fv|iv}",
    "GetPixelMap{|fv|uiv|usv}",
    "GetPolygonStipple",
    "GetString",
    "GetTexEnv{|fv|iv}",
    "GetTexImage",
    "GetTexLevelParameter{|fv|iv}",
    "GetTexParameter{|fv|iv}",
    "Hint",
    "Index{|d|f|i|s|ub}{|v}",
    "IndexMask",
    "IndexPointer",
    "InitNames",
    "InterleavedArrays",
    "IsList",
    "IsTexture",
    "Light{|f|i}{|v}",
    "LightModel{|f|i}{|v}",
    "LineStipple",
    "LineWidth",
    "ListBase",
    "LoadIdentity",
    "{Load|Mult}{|Transpose}Matrix{|d|f}",
    "LoadName",
    "LogicOp",
    "Map{1|2}{|d|f}",
    "MapGrid{1|2}{|d|f}",
    "Material{|f|i}{|v}",
    "MatrixMode",
    "NewList",
    "Normal{|3}{|b|d|f|i|s}{|v}",
    "NormalPointer",
    "Ortho",
    "PassThrough",
    "PixelMap{|f|ui|us}{|v}",
    "PixelStore{|f|i}",
    "PixelTransfer{|f|i}",
    "PixelZoom",
    "PointSize",
    "PolygonMode",
    "PolygonOffset",
    "PolygonStipple",
    "{Push|Pop}{|Client}Attrib",
    "{Push|Pop}{Matrix|Name}",
    "PrioritizeTextures",
    "RasterPos{|2|3|4}{|d|f|i|s}{|v}",
    "ReadBuffer",
    "ReadPixels",
    "Rect{|d|f|i|s}{|v}",
    "RenderMode",
    "{Rotate|Scale|Translate}{|d|f}",
    "Scissor",
    "SelectBuffer",
    "ShadeModel",
    "StencilFunc",
    "StencilMask",
    "StencilOp",
    "TexCoord{|1|2|3|4}{|d|f|i|s}{|v}",
    "TexCoordPointer",
    "TexEnv{|f|i}{|v}",
    "TexImage{1D|2D|3D}",
    "TexParameter{|f|i}{|v}",
    "TexSubImage{1D|2D|3D}",
    "Vertex{|2|3|4}{|d|f|i|s}{|v}",
    "VertexPointer",
    "Viewport",
    // 1.2
    "BlendColor",
    "BlendEquation",
    "{|Copy}Color{|Sub}Table",
    "ColorTableParameter{|f|i}{|v}",
    "{|Copy}ConvolutionFilter{1D|2D}",
    "ConvolutionParameter{|f|i}{|v}",
    "DrawRangeElements",
    "Get{ColorTable|Convolution|Histogram|Minmax}Parameter{|fv|iv}",
    "Get{ColorTable|ConvolutionFilter|Histogram|Minmax|SeparableFilter}",
    "{|Reset}Histogram",
    "{|Reset}Minmax",
    "SeparableFilter2D",
    // 1.3
    "ClientActiveTexture",
    "CompressedTex{|Sub}Image{1D|2D|3D}",
    "GetCompressedTexImage",
    "MultiTexCoord{|1|2|3|4}{|d|f|i|s}{|v}",
    "SampleCoverage",
    // 1.4
    "BlendFuncSeparate",
    "FogCoord{|d|f}{|v}",
    "FogCoordPointer",
    "MultiDraw{Arrays|Elements}",
    "PointParameter{|f|i}{|v}",
    "SecondaryColor{|3}{|b|d|f|i|s|ub|ui|us}{|v}",
    "SecondaryColorPointer",
    "WindowPos{|2|3}{|d|f|i|s}{|v}",
    // 1.5
    "{Begin|End}Query",
    "BindBuffer",
    "Buffer{|Sub}Data",
    "{Delete|Gen}{Buffers|Queries}",
    "GetBuffer{Parameter|Parameteriv|Pointer|Pointerv|SubData}",
    "GetQuery{|iv|Object|Objectiv|Objectuiv}",
    "Is{Buffer|Query}",
    "{Map|Unmap}Buffer",
    // NV_register_combiners, which the specification uses to subtract the two samples.
    "CombinerParameter{|f|i}{|v}NV",
    "{Combiner|FinalCombiner}InputNV",
    "CombinerOutputNV",
    "GetCombiner{Input|Output}Parameter{|fv|iv}NV",
    "GetFinalCombinerInputParameter{|fv|iv}NV",
];

/// Capabilities for `Enable`, except lights, which are numbered; with the suffixes of extensions.
const CAPABILITIES: &[&str] = &[
    "{ALPHA|DEPTH|SCISSOR|STENCIL}_TEST",
    "AUTO_NORMAL",
    "BLEND",
    "CLIP_PLANE{0|1|2|3|4|5}",
    "COLOR_{LOGIC_OP|MATERIAL}",
    "COLOR_SUM{|_ARB|_EXT}",
    "{|POST_COLOR_MATRIX_|POST_CONVOLUTION_}COLOR_TABLE",
    "CONVOLUTION_{1D|2D}{|_EXT}",
    "CULL_FACE",
    "DITHER",
    "FOG",
    "HISTOGRAM{|_EXT}",
    "{|INDEX_}LOGIC_OP",
    "LIGHTING",
    "LINE_{SMOOTH|STIPPLE}",
    "MAP{1|2}_{COLOR_4|INDEX|NORMAL|TEXTURE_COORD_1|TEXTURE_COORD_2|TEXTURE_COORD_3|TEXTURE_COORD_4|VERTEX_3|VERTEX_4}",
    "MINMAX{|_EXT}",
    "MULTISAMPLE{|_ARB|_EXT|_SGIS}",
    "NORMALIZE",
    "POINT_SMOOTH",
    "POINT_SPRITE{|_ARB|_NV}",
    "POLYGON_{SMOOTH|STIPPLE|OFFSET_FILL|OFFSET_LINE|OFFSET_POINT}",
    "RESCALE_NORMAL{|_EXT}",
    "SAMPLE_{ALPHA_TO_COVERAGE|ALPHA_TO_ONE|COVERAGE}{|_ARB}",
    "SEPARABLE_2D{|_EXT}",
    "TEXTURE_{1D|2D}",
    "TEXTURE_3D{|_EXT}",
    "TEXTURE_CUBE_MAP{|_ARB|_EXT}",
    "TEXTURE_GEN_{S|T|R|Q}",
    "{COLOR|EDGE_FLAG|FOG_COORD|INDEX|NORMAL|SECONDARY_COLOR|TEXTURE_COORD|VERTEX}_ARRAY{|_EXT}",
    "{REGISTER_COMBINERS|PER_STAGE_CONSTANTS}_NV",
    "TEXTURE_RECTANGLE_{ARB|EXT|NV}",
];

/// Suffixes of names that were extensions before they became part of OpenGL.
const VENDORS: [&str; 4] = ["ARB", "EXT", "NV", "SGIS"];

static ALL_COMMANDS: LazyLock<BTreeSet<String>> = LazyLock::new(|| all(COMMANDS));
static ALL_CAPABILITIES: LazyLock<BTreeSet<String>> = LazyLock::new(|| all(CAPABILITIES));

fn all(patterns: &[&str]) -> BTreeSet<String> {
    patterns.iter().flat_map(|pattern| expanded(pattern)).collect()
}

/// Every name that a pattern stands for.
fn expanded(pattern: &str) -> Vec<String> {
    let Some((before, rest)) = pattern.split_once('{') else { return vec![pattern.to_owned()] };
    let (choices, after) = rest.split_once('}').expect("bug: a brace is closed");
    let ends = expanded(after);
    let each = |choice| ends.iter().map(move |end| format!("{before}{choice}{end}"));
    choices.split('|').flat_map(each).collect()
}

/// A name without the suffix of an extension; `None` if it has none.
fn plain(name: &str) -> Option<&str> {
    VENDORS.iter().find_map(|end| name.strip_suffix(end))
}

/// True if there is a command of this name, given without `gl`.
pub(super) fn is_command(name: &str) -> bool {
    ALL_COMMANDS.contains(name) || plain(name).is_some_and(|name| ALL_COMMANDS.contains(name))
}

/// Names of the commands.
pub(super) fn commands() -> impl Iterator<Item = &'static str> {
    ALL_COMMANDS.iter().map(String::as_str)
}

/// A capability by its name without `GL_`; returned without the suffix of an extension.
pub(super) fn capability(name: &str) -> Option<&str> {
    let known = ALL_CAPABILITIES.contains(name).then_some(name)?;
    let core = plain(name).and_then(|name| name.strip_suffix('_'));
    Some(core.filter(|core| ALL_CAPABILITIES.contains(*core)).unwrap_or(known))
}

/// Names of the capabilities.
pub(super) fn capabilities() -> impl Iterator<Item = &'static str> {
    ALL_CAPABILITIES.iter().map(String::as_str)
}

/// True if each texture unit has its own copy.
pub(super) fn is_of_unit(capability: &str) -> bool {
    // Arrays belong to the client, and the coordinates of evaluators don't belong to a unit.
    capability.starts_with("TEXTURE_") && !capability.ends_with("_ARRAY")
}
