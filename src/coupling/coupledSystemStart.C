/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Velocities and rates at the start of a run that the equations have there:

        feSolution      initialVelocities projected;    // or given, the default
                        initialRates consistent;        // or nil, the default

    Velocities are projected onto what is given at boundaries and the equation of
    continuity: those nearest to the fields as they are, in the mean square with the
    density. From rest it is the potential flow, with its boundary layers within an
    element, which a steady run may begin with and an impulsive start has.

    The accelerations of fluid and solid and the pressure are those of one very
    short step of Euler's from the given velocities and displacements, under
    the loads of the start. Where a start is impulsive (a wall that moves at
    once in a fluid at rest) there are no such rates; a step of a quarter of
    the length tells.
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "coastingScheme.H"
#include "hasMultipliers.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of the fields, the rates and the multipliers: the mesh's motion follows
static bool isRate(const word& name)
{
    if (name.startsWith("meshDisplacement")) return false;
    return name.endsWith("Rate") || name.endsWith("Acceleration") || name == "p";
}


template<class Type>
static void keepRates
(
    const HashTable<Field<Type>*>& from,
    HashTable<Field<Type>>& to,
    bool (*wanted)(const word&)
)
{
    forAllConstIters(from, iter) if (wanted(iter.key())) to.insert(iter.key(), *iter.val());
}


template<class Type>
static void putRates
(
    const HashTable<Field<Type>>& from,
    const HashTable<Field<Type>*>& to
)
{
    forAllConstIters(to, iter) if (from.found(iter.key())) *iter.val() = from[iter.key()];
}


template<class Type>
static bool agree(const Field<Type>& a, const Field<Type>& b)
{
    return gSum(magSqr(Field<Type>(a - b))()) <= sqr(0.05)*gSum(magSqr(a)()) + VSMALL;
}


//- Name of a list that two steps do not agree upon. The slope of a pressure
//  may go, as it does where there is no consistent pressure at the start
template<class Type>
static word differing
(
    const HashTable<Field<Type>>& a,
    HashTable<Field<Type>>& b
)
{
    for (const word& name : a.sortedToc())
    {
        if (agree(a[name], b[name])) continue;
        if (name != "pRate") return name;
        b.erase(name);
    }
    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::coupledSystem::schemes Foam::coupledSystem::coastingSchemes() const
{
    schemes list;
    for (label r = 0; r < regions_.size(); ++r)
    {
        list.append(new autoPtr<feTimeScheme>(new coastingScheme(runTime_.deltaTValue())));
    }
    return list;
}


void Foam::coupledSystem::putRates(const startRates& rates)
{
    forAll(regions_, r)
    {
        for (const statePart& part : regions_[r].state().parts())
        {
            Foam::putRates(rates.scalars[r], part.scalars());
            Foam::putRates(rates.vectors[r], part.vectors());
        }
    }
}


void Foam::coupledSystem::keepRates(startRates& rates, bool (*wanted)(const word&))
{
    rates.scalars.setSize(regions_.size());
    rates.vectors.setSize(regions_.size());
    forAll(regions_, r)
    {
        for (const statePart& part : regions_[r].state().parts())
        {
            Foam::keepRates(part.scalars(), rates.scalars[r], wanted);
            Foam::keepRates(part.vectors(), rates.vectors[r], wanted);
        }
    }
}


bool Foam::coupledSystem::stepTo(const scalar time, const scalar deltaT)
{
    for (feRegion& region : regions_) region.state().shift();
    runTime_.setDeltaT(deltaT, false);
    runTime_.setTime(time, kept_.at.index);
    return step();
}


bool Foam::coupledSystem::solveRates
(
    const scalar deltaT,
    startRates& rates,
    bool (*wanted)(const word&)
)
{
    store();
    schemes Euler(EulerSchemes());
    exchange(Euler);

    // Values that are given go on from those of the start
    const bool ok = stepTo(kept_.at.time + deltaT, deltaT);
    exchange(Euler);
    keepRates(rates, wanted);
    restore();
    return ok;
}


bool Foam::coupledSystem::startContinuously()
{
    // A very short step changes a velocity by the gradient of the pressure only
    Info<< "Projection of the velocities" << nl;
    startRates velocities;
    const auto isVelocity = [](const word& name) { return name == "U"; };
    if (!solveRates(1e-3*runTime_.deltaTValue(), velocities, isVelocity)) return false;
    putRates(velocities);
    for (feRegion& region : regions_) region.state().shift();
    return true;
}


void Foam::coupledSystem::startConsistently()
{
    if (regions_[0].timeScheme().steady()) return;
    Info<< "Rates at the start" << nl;

    const scalar deltaT = 1e-4*runTime_.deltaTValue();
    startRates rates, check;
    bool ok = solveRates(deltaT, rates, isRate) && solveRates(deltaT/4, check, isRate);
    word what;
    forAll(regions_, r)
    {
        if (!ok || !what.empty()) break;
        what = differing(rates.scalars[r], check.scalars[r]);
        if (what.empty()) what = differing(rates.vectors[r], check.vectors[r]);
        if (!what.empty()) what = regions_[r].name() + '.' + what;
    }

    times_ = systemTimes();   // of the steps to come
    if (!ok || !what.empty())
    {
        WarningInFunction
            << "initialRates consistent: "
            << (ok ? "the start is impulsive, " + what + " grows as the step becomes shorter."
                   : string("a very short step did not converge."))
            << " The run starts without rates" << endl;
        return;
    }
    putRates(check);
    settle();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupledSystem::projects() const
{
    for (const feRegion& region : regions_)
    {
        const auto* fluid = dynamic_cast<const hasMultipliers*>(&region);
        if (!fluid) continue;
        const word elements(feRegion::readSchemes(region.mesh()).get<word>("elements"));
        if (!fluid->multipliers().empty() && elements != "equalOrder") continue;
        Info<< "    The state is interpolated, not projected: fluid " << region.name()
            << " has a bulk modulus or equalOrder" << nl;
        return false;
    }
    return true;
}


void Foam::coupledSystem::settle()
{
    followAtStart();
    for (feRegion& region : regions_) region.state().shift();
}


bool Foam::coupledSystem::project()
{
    if (regions_[0].timeScheme().steady()) return true;
    Info<< "Projection of the velocities" << nl;
    const auto isVelocity = [](const word& name) { return name == "U" || name == "DVelocity"; };
    const auto isPressure = [](const word& name) { return name == "p" || name == "pRate"; };

    // A very short step changes a velocity by the gradient of a pressure, which
    // makes it continuous; the next one has the accelerations of those that are,
    // on the mesh as it moves. Pressures with a history stay as they are
    const scalar deltaT = 1e-3*runTime_.deltaTValue();
    startRates velocities, rates, pressures;
    keepRates(pressures, isPressure);
    forAll(regions_, r)
    {
        const auto* region = dynamic_cast<const hasMultipliers*>(&regions_[r]);
        if (region) for (const word& name : region->multipliers()) pressures.scalars[r].erase(name);
    }
    store();
    schemes coasting(coastingSchemes());
    exchange(coasting);
    bool ok = stepTo(kept_.at.time + deltaT, deltaT);
    keepRates(velocities, isVelocity);
    putRates(pressures);
    ok = ok && stepTo(kept_.at.time + 2*deltaT, deltaT);
    exchange(coasting);
    keepRates(rates, isRate);
    restore();
    if (!ok) return false;

    // Those now, from those at the end of the first step
    forAll(regions_, r) for (const word& name : velocities.vectors[r].toc())
    {
        const word rate(name == "U" ? "URate" : "DAcceleration");
        velocities.vectors[r][name] -= deltaT*rates.vectors[r][rate];
    }
    putRates(rates);
    putRates(velocities);
    putRates(pressures);

    // Followers take the rates. Their places stay to the bit: a restart makes the
    // weights of interfaces from them
    startRates places;
    keepRates(places, [](const word& name) { return name == "meshDisplacement"; });
    followAtStart();
    putRates(places);
    for (feRegion& region : regions_) region.state().shift();
    return true;
}


// ************************************************************************* //
