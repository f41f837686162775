#pragma once

// Everything of the link target wavecurve::certified, namespace wavecurve::certified: numbers with
// proof. Ball is an enclosure, Rational a fraction; filters at any precision, their connection
// coefficients, Sobolev exponents and diagnostics; decimals and doubles whose rounding is proved.

#include "wavecurve/certified/autocorrelation.hpp"
#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/basis_function.hpp"
#include "wavecurve/certified/certified_decimals.hpp"
#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/decimal_enclosure.hpp"
#include "wavecurve/certified/diagnostics.hpp"
#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/flint.hpp"
#include "wavecurve/certified/integrals/exact_integrals.hpp"
#include "wavecurve/certified/integrals/homogeneous_operator.hpp"
#include "wavecurve/certified/integrals/integral_decimals.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/integrals/quadrature.hpp"
#include "wavecurve/certified/lifting.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/certified/moments.hpp"
#include "wavecurve/certified/nearest_filter_bank.hpp"
#include "wavecurve/certified/point_values.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/certified/refinable.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/certified/user_filter.hpp"
