/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "springsPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(springsPointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        springsPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::springsLoad::springsLoad(const dictionary& dict, const Time&)
:
    springs_(dict.subDict("springs")),
    stiffness_(Zero),
    damping_(Zero)
{
    for (const entry& e : springs_)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(springs_)
                << "Entry '" << e.keyword() << "' of springs is no dictionary, expected "
                << e.keyword() << " { direction (x y z); stiffness ...; damping ...; }"
                << exit(FatalIOError);
        }
        const dictionary& spring = e.dict();
        reportUnknownEntries(spring, {"direction", "stiffness", "damping"});
        symmTensor along(symmTensor::I);
        if (spring.found("direction"))
        {
            const vector n(spring.get<vector>("direction"));
            if (!(mag(n) > VSMALL && mag(n) < GREAT))
            {
                FatalIOErrorInFunction(spring)
                    << "Found direction " << n << ", expected a vector that is not nil"
                    << exit(FatalIOError);
            }
            along = sqr(n/mag(n));
        }
        const scalar k = spring.lookupOrDefault<scalar>("stiffness", 0);
        const scalar c = spring.lookupOrDefault<scalar>("damping", 0);
        if (!(k >= 0 && c >= 0 && k + c > 0 && k + c < GREAT))
        {
            FatalIOErrorInFunction(spring)
                << "Found stiffness " << k << " and damping " << c
                << ", expected numbers that are not negative, and one that is positive"
                << exit(FatalIOError);
        }
        stiffness_ += k*along;
        damping_ += c*along;
    }
    if (springs_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No spring in springs, expected one at least, as in"
            << " springs { normal { direction (1 0 0); stiffness 1e6; } }" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::springsLoad::write(Ostream& os) const
{
    springs_.writeEntry("springs", os);
}


// ************************************************************************* //
