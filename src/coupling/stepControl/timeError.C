/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeError.H"
#include "Time.H"
#include "fourDigits.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Root mean square over the nodes of all ranks
static scalar rms(const feRegion& region, const vectorField& f)
{
    scalar sum = 0, n = 0;
    for (const label node : region.fe().copies().ownedNodes())
    {
        sum += magSqr(f[node]);
        n += 1;
    }
    reduce(sum, sumOp<scalar>());
    reduce(n, sumOp<scalar>());
    return ::sqrt(sum/max(n, scalar(1)));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class F>
void Foam::timeError::forFields(const F& f) const
{
    const std::pair<word, word> fields[] =
    {
        {"U", "URate"}, {"D", "DVelocity"}, {"meshDisplacement", "meshDisplacementVelocity"}
    };
    for (const feRegion& region : regions_) for (const auto& field : fields)
    {
        const vectorField* q = region.state().find<vector>(field.first);
        const vectorField* rate = region.state().find<vector>(field.second);
        if (q && rate) f(region, field.first, *q, *rate);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeError::timeError(const Time& runTime, const PtrList<feRegion>& regions, const bool wanted)
:
    IOdictionary
    (
        IOobject
        (
            "timeError", runTime.timeName(), "uniform", runTime,
            wanted ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
            wanted ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
        )
    ),
    regions_(regions),
    wanted_(wanted),
    sizes_(lookupOrDefault("sizes", scalarField()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::timeError::store()
{
    if (!wanted_) return;
    rates_.clear();
    forFields([&](const feRegion&, const word&, const vectorField&, const vectorField& rate)
    {
        rates_.append(rate);
    });
    if (sizes_.size() != rates_.size()) sizes_ = scalarField(rates_.size(), 0);
}


Foam::scalar Foam::timeError::estimate(const TimeState& time)
{
    static const scalar kept = 0.99;
    if (!wanted_) return 0;
    scalar error = 0;
    word by;
    label i = 0;
    forFields([&](const feRegion& region, const word& name, const vectorField& q, const vectorField& rate)
    {
        sizes_[i] = max(kept*sizes_[i], rms(region, q));
        const scalar change = rms(region, rate - rates_[i]);
        const scalar e = sizes_[i] > 0 ? time.deltaTValue()*change/(12*sizes_[i]) : 0;
        if (e > error)
        {
            error = e;
            by = region.name() + '.' + name;
        }
        ++i;
    });
    if (time.timeIndex() < 3 || by.empty()) return 0;
    Info<< "Time error " << fourDigits(error) << " of " << by << nl;
    return error;
}


bool Foam::timeError::writeData(Ostream& os) const
{
    const auto digits = os.precision(17);
    os.writeEntry("sizes", sizes_);
    os.precision(digits);
    return os.good();
}


// ************************************************************************* //
