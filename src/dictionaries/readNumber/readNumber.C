/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readNumber.H"
#include "dimensionedScalar.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool endsWithNumber(const entry& e)
{
    return e.isStream() && !e.stream().empty() && e.stream().last().isNumber();
}


static scalar readAny(const dictionary& dict, const word& keyword, const dimensionSet& dimensions)
{
    const entry& e = dict.lookupEntry(keyword, keyType::REGEX);
    if (!endsWithNumber(e))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << keyword << " is no number, expected one after its"
            << " dimensions " << dimensions << ", or alone" << exit(FatalIOError);
    }
    return dimensionedScalar(keyword, dimensions, dict).value();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::readNumber
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dimensions,
    const scalar low,
    const scalar high
)
{
    const scalar value = readAny(dict, keyword, dimensions);
    if (!(value > low && value < high))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << value << ", expected a number > " << low;
        if (high < GREAT) FatalIOError << " and < " << high;
        FatalIOError << exit(FatalIOError);
    }
    return value;
}


Foam::scalar Foam::readNotNegative
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dimensions
)
{
    const scalar value = readAny(dict, keyword, dimensions);
    if (!(value >= 0 && value < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << value << ", expected a number >= 0" << exit(FatalIOError);
    }
    return value;
}


// ************************************************************************* //
