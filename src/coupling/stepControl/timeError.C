/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeError.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static scalar largest(const vectorField& f)
{
    scalar most = 0;
    for (const vector& x : f) most = max(most, mag(x));
    return returnReduce(most, maxOp<scalar>());
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class F>
void Foam::timeError::forFields(const F& f) const
{
    // Of fields known by their velocity, and by their displacement
    const std::pair<const char*, const char*> levels[] = {{"", "Rate"}, {"Velocity", "Acceleration"}};
    for (const feRegion& region : regions_)
    {
        for (const char* name : {"U", "D", "meshDisplacement"}) for (const auto& level : levels)
        {
            const vectorField* v = region.state().find<vector>(word(name) + level.first);
            const vectorField* a = region.state().find<vector>(word(name) + level.second);
            if (v && a) f(*v, *a);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::timeError::store()
{
    if (!wanted_) return;
    v_.clear();
    a_.clear();
    forFields([&](const vectorField& v, const vectorField& a)
    {
        v_.append(v);
        a_.append(a);
    });
}


Foam::scalar Foam::timeError::estimate(const TimeState& time) const
{
    if (!wanted_ || time.timeIndex() < 3) return 0;
    scalar error = 0;
    label i = 0;
    forFields([&](const vectorField& v, const vectorField& a)
    {
        const scalar size = max(largest(v), largest(v_[i]));
        const scalar change = largest(a - a_[i]);
        if (size > 0) error = max(error, time.deltaTValue()*change/(12*size));
        ++i;
    });
    return error;
}


// ************************************************************************* //
