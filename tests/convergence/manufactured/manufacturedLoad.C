/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "manufacturedLoad.H"
#include "manufacturedSolution.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(manufacturedLoadPointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        manufacturedLoadPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::manufacturedLoad::manufacturedLoad(const dictionary& dict, const Time&)
:
    of_(dict.get<word>("of")),
    normal_(dict.get<vector>("normal"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::manufacturedLoad::traction(const point& x, const scalar t) const
{
    const manufacturedSolution& s = manufacturedSolution::theSolution();
    return of_ == "flow" ? s.flowStress(x, t) & normal_ : s.interfaceLoad(x, t, normal_);
}


void Foam::manufacturedLoad::write(Ostream& os) const
{
    os.writeEntry("of", of_);
    os.writeEntry("normal", normal_);
}


// ************************************************************************* //
