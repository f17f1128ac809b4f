/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spaceFunction.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::spaceFunction::checkExponents(const dictionary& dict) const
{
    for (const auto& term : terms_)
    {
        const vector& n = term.second();
        for (direction a = 0; a < vector::nComponents; ++a)
        {
            if (n[a] >= 0 && n[a] == std::floor(n[a])) continue;
            FatalIOErrorInFunction(dict)
                << "Term " << term << " has exponents " << n
                << ", expected whole numbers >= 0" << nl
                << "A term is (coefficient exponents), both vectors, as in"
                << " ((6 0 0) (0 1 0)) for 6 y in direction x"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::spaceFunction::spaceFunction(const dictionary& dict, const Time& runTime)
:
    terms_(dict.lookupOrDefault("terms", List<Tuple2<vector, vector>>())),
    code_(dict, runTime),
    origin_(dict.lookupOrDefault<vector>("origin", Zero))
{
    checkExponents(dict);
    if (terms_.empty() && code_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Profile " << dict.dictName() << " has neither terms nor code;"
            << " expected one of them at least" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::spaceFunction::operator()(const vector& x, const scalar t) const
{
    const vector X = x - origin_;

    vector u = code_.empty() ? vector::zero : code_(X, t);
    for (const auto& term : terms_)
    {
        const vector& n = term.second();
        u += term.first()*pow(X.x(), n.x())*pow(X.y(), n.y())*pow(X.z(), n.z());
    }
    return u;
}


void Foam::spaceFunction::write(Ostream& os) const
{
    if (!terms_.empty()) os.writeEntry("terms", terms_);
    code_.write(os);
    if (origin_ != vector::zero) os.writeEntry("origin", origin_);
}


// ************************************************************************* //
