/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fixedComponentsPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(fixedComponentsPointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        fixedComponentsPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fixedComponentsCondition::fixedComponentsCondition
(
    const dictionary& dict,
    const Time& runTime
)
{
    for (const entry& e : dict.subDict("components"))
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict.subDict("components"))
                << "Entry '" << e.keyword() << "' of components is no dictionary, expected "
                << e.keyword() << " { direction (x y z); value ...; }" << exit(FatalIOError);
        }
        const vector n(e.dict().get<vector>("direction"));
        if (!(mag(n) > VSMALL) || !std::isfinite(mag(n)))
        {
            FatalIOErrorInFunction(e.dict())
                << "Found direction " << n << ", expected a vector that is not nil"
                << exit(FatalIOError);
        }
        reportUnknownEntries(e.dict(), {"direction", "value", "valueCoeffs", "code"});
        names_.append(e.keyword());
        directions_.append(n/mag(n));
        values_.append(new optionalFunction1<scalar>("value", e.dict(), 0));
        codes_.append(profileCode(e.dict(), runTime));
    }
    if (dict.found("backflowStabilisation"))
    {
        backflow_ = readNotNegative(dict, "backflowStabilisation", dimless);
    }
    if (directions_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No component in components, expected one at least, as in"
            << " components { normal { direction (1 0 0); } }" << exit(FatalIOError);
    }
}


Foam::fixedComponentsCondition::fixedComponentsCondition(const fixedComponentsCondition& c)
:
    names_(c.names_),
    directions_(c.directions_),
    codes_(c.codes_),
    backflow_(c.backflow_)
{
    for (const optionalFunction1<scalar>& f : c.values_) values_.append(new optionalFunction1<scalar>(f));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fixedComponentsCondition::write(Ostream& os) const
{
    os.beginBlock("components");
    forAll(names_, k)
    {
        os.beginBlock(names_[k]);
        os.writeEntry("direction", directions_[k]);
        values_[k].write(os);
        codes_[k].write(os);
        os.endBlock();
    }
    os.endBlock();
    if (backflow_ != 0.5) os.writeEntry("backflowStabilisation", backflow_);
}


// ************************************************************************* //
