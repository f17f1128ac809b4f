/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidSurface.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(rigidSurface, 0);
    defineRunTimeSelectionTable(rigidSurface, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::rigidSurface> Foam::rigidSurface::New(const dictionary& dict)
{
    const word type(dict.get<word>("type"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup(dict, "rigid surface", type, *dictionaryConstructorTablePtr_)
            << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rigidSurface::check(const Vector<label>& geometricD, const dictionary& dict) const
{
    for (direction c = 0; c < 3; ++c)
    {
        vector normal = Zero;
        normal[c] = 1;
        if (geometricD[c] > 0 || isAlong(normal)) continue;
        FatalIOErrorInFunction(dict)
            << "The " << type() << " is not the same all along " << normal
            << ", the normal of a 2-D case, as a plane or a cylinder along it is" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::vector Foam::rigidSurface::readDirection(const word& name, const dictionary& dict)
{
    const vector n(dict.get<vector>(name));
    if (!(mag(n) > VSMALL && mag(n) < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "Found " << name << ' ' << n << ", expected a vector that is not nil"
            << exit(FatalIOError);
    }
    return n/mag(n);
}


Foam::scalar Foam::rigidSurface::readRadius(const dictionary& dict)
{
    return readNumber(dict, "radius", dimLength, 0, GREAT);
}


Foam::scalar Foam::rigidSurface::readSide(const dictionary& dict)
{
    const word side(dict.lookupOrDefault<word>("side", "outside"));
    if (side == "outside") return 1;
    if (side == "inside") return -1;
    FatalIOErrorInFunction(dict)
        << "Found side " << side << ", expected outside or inside: where the solid is"
        << exit(FatalIOError);
    return 0;
}


Foam::rigidSurface::distance Foam::rigidSurface::round
(
    const vector& from,
    const symmTensor& across,
    const scalar radius,
    const scalar side
)
{
    const vector r(across & from);
    const scalar d = max(mag(r), 1e-6*radius);
    const vector n(r/d);
    return {side*(d - radius), side*n, symmTensor((side/d)*(across - sqr(n)))};
}


// ************************************************************************* //
