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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::manufacturedPointPatchVectorField::motion(const point& x, const scalar t) const
{
    using namespace constant::mathematical;
    return ::sin(pi*x.y())*0.5*(1 - ::cos(twoPi*t))*moves_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::manufacturedPointPatchVectorField::at
(
    const point& x,
    const scalar t
) const
{
    const manufacturedSolution& s = manufacturedSolution::theSolution();
    const word& field = internalField().name();
    if (field == "pointDisplacement") return motion(x, t);
    return field == "pointU" ? s.U(x + motion(x, t), t) : s.D(x, t);
}


// ************************************************************************* //
