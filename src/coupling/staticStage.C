/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "staticStage.H"
#include "readNumber.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::staticStage::staticStage(const dictionary& solution)
:
    endTime_(-GREAT),
    deltaT_(0),
    on_(false)
{
    if (!solution.found("staticStage")) return;
    const dictionary dict(subDictOrEmpty(solution, "staticStage"));
    reportUnknownEntries(dict, {"endTime", "deltaT", "timeScheme"});
    endTime_ = readNumber(dict, "endTime", dimTime, -GREAT, GREAT);
    deltaT_ = readNumber(dict, "deltaT", dimTime, 0, GREAT);
    scheme_ = subDictOrEmpty(dict, "timeScheme");
    if (scheme_.empty()) scheme_.add("type", word("steady"));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::staticStage::select(PtrList<feRegion>& regions, const scalar time)
{
    if (has(time) == on_) return;
    on_ = !on_;
    if (others_.empty()) for (label r = 0; r < regions.size(); ++r)
    {
        others_.append(new autoPtr<feTimeScheme>(feTimeScheme::New(scheme_)));
    }
    forAll(regions, r)
    {
        const feTimeScheme& before = regions[r].timeScheme();
        others_[r]->setDeltaT(before.deltaT(), before.deltaT0());
        regions[r].exchange(others_[r]);
    }
}


// ************************************************************************* //
