//! Still fields, made from a seed: heights, normal maps and their mips.
