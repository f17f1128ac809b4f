/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "qualityLimits.H"
#include "unknownEntries.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::qualityLimits::qualityLimits(const dictionary& dict)
:
    limits_(qualityMeasures().size())
{
    wordList names(limits_.size());
    forAll(limits_, m)
    {
        const qualityMeasure& measure = qualityMeasures()[m];
        names[m] = measure.name;
        const scalar none = measure.smallIsBad ? -GREAT : GREAT;
        limits_[m] = dict.getOrDefault<scalar>(measure.name, none);
        if (limits_[m] != none && !(limits_[m] > 0 && limits_[m] < GREAT))
        {
            FatalIOErrorInFunction(dict)
                << "The limit " << measure.name << " is " << limits_[m]
                << ", expected a number > 0" << exit(FatalIOError);
        }
    }
    reportUnknownEntries(dict, names);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::qualityLimits::nBroken
(
    const elementQualities& now,
    const elementQualities& reference
) const
{
    labelList n(limits_.size(), 0);
    forAll(now, b) forAll(now[b], e) forAll(n, m)
    {
        n[m] += broken(m, qualityMeasures()[m].of(now[b][e], reference[b][e]));
    }
    for (label& nm : n) reduce(nm, sumOp<label>());
    return n;
}


// ************************************************************************* //
