/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "manufacturedPointPatchVectorField.H"
#include "manufacturedSolution.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePointPatchTypeField
    (
        pointPatchVectorField,
        manufacturedPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::manufacturedPointPatchVectorField::at
(
    const point& x,
    const scalar t
) const
{
    const manufacturedSolution& s = manufacturedSolution::theSolution();
    if (internalField().name() != "pointU") return s.D(x, t);
    return s.U(x + ::sin(constant::mathematical::twoPi*t)*moves_, t);
}


// ************************************************************************* //
