#pragma once

namespace wavecurve::tools {

/// Gives GMP, MPFR, FLINT, Arb and libxml2 functions that take memory from malloc and end the program,
/// with one line and exit code environment_failed, where it is refused. GMP allows no more: its
/// manual says that these functions must return memory or not at all, and it keeps state that an
/// exception would break; its own print and abort, and so do FLINT's. libxml2 returns an error, but
/// not from everywhere. A library must not end the program that uses it, so wavecurve does nothing of
/// this kind, and every program decides. To be called before the first number is made.
void end_where_c_libraries_lack_memory();

}  // namespace wavecurve::tools
