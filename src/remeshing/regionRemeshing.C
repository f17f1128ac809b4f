/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionRemeshing.H"
#include "elementQuality.H"
#include "fourDigits.H"
#include "wallPolyPatch.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static IOobject dictIO(const feRegion& region)
{
    return IOobject
    (
        "remeshDict", region.mesh().time().constant(), region.mesh(),
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
}


} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vectorField Foam::regionRemeshing::present() const
{
    return region_.fe().points() + static_cast<const feRegion&>(region_).motion().D;
}


void Foam::regionRemeshing::findPatches()
{
    DynamicList<label> patches;
    for (const feInterface& i : system_.interfaces()) if (&i.follower() == &region_) patches.append(i.followerPatches());
    if (patches.empty())
    {
        for (const polyPatch& pp : region_.mesh().boundaryMesh()) if (isA<wallPolyPatch>(pp)) patches.append(pp.index());
    }
    patches_.transfer(patches);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::regionRemeshing::regionRemeshing(coupledSystem& system, const label regioni)
:
    system_(system),
    regioni_(regioni),
    region_(system.regions()[regioni]),
    dict_(dictIO(region_)),
    selection_(subDictOrEmpty(dict_, "region")),
    remesher_(remesher::New(dict_, region_.mesh().time())),
    mapping_(meshMapping::New(dict_)),
    table_(region_, subDictOrEmpty(dict_, "bounds")),
    memory_(region_, subDictOrEmpty(dict_, "size")),
    triedAt_(-1)
{
    reportUnknownEntries
    (
        dict_,
        {
            "remesher", dict_.get<word>("remesher") + "Coeffs", "region", "criteria", "size", "bounds",
            "mapping", mapping_->type() + "Coeffs"
        }
    );
    const dictionary criteria(subDictOrEmpty(dict_, "criteria"));
    for (const entry& e : criteria) criteria_.append(remeshCriterion::New(criteria.subDict(e.keyword())).ptr());
    selection_.check(region_.fe());
    findPatches();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::regionRemeshing::checkStart() const
{
    const vectorField& X = region_.fe().points();
    const vectorField none(X.size(), Zero);
    for (const remeshCriterion& c : criteria_)
    {
        const label n = c.nAtStart({region_.fe(), X, none, region_.mesh().time()});
        if (!n) continue;
        FatalIOErrorInFunction(dict_)
            << "Region " << region_.name() << ": " << n << " elements of the mesh are past a limit of"
            << " criteria before anything has moved, so that the mesh would be exchanged without end."
            << nl << "feCheckMesh -region " << region_.name() << " -worst 5 shows them: choose weaker limits"
            << exit(FatalIOError);
    }
}


bool Foam::regionRemeshing::wanted(const feRegion& region)
{
    IOobject io(dictIO(region));
    return returnReduce(io.typeHeaderOk<IOdictionary>(), orOp<bool>());
}


Foam::labelHashSet Foam::regionRemeshing::bad(string& why, const bool inverted) const
{
    // A step that failed has left no displacement: go on at the rate of the one before
    const motionField& motion = static_cast<const feRegion&>(region_).motion();
    const scalar deltaT = region_.mesh().time().deltaTValue();
    const vectorField x(present()), dx(inverted ? vectorField(deltaT*motion.v) : vectorField(motion.D - motion.D0));
    labelHashSet cells;
    for (const remeshCriterion& c : criteria_)
    {
        const string reason(c.asks({region_.fe(), x, dx, region_.mesh().time()}, cells));
        if (!reason.empty()) why += (why.empty() ? "" : ", ") + reason;
    }
    if (!inverted) return cells;

    why = "an element was inverted";
    const inversionForecast first(forecast(region_.fe(), x, dx));
    if (first.element >= 0) cells.insert(region_.fe().blocks()[first.block].cells[first.element]);
    return cells;
}


bool Foam::regionRemeshing::update(const bool inverted)
{
    const label index = region_.mesh().time().timeIndex();
    if (index == triedAt_) return false;
    string why;
    const labelHashSet cells(bad(why, inverted));
    if (why.empty()) return false;
    triedAt_ = index;
    return exchange(why, cells);
}


bool Foam::regionRemeshing::any(const labelHashSet& bad) const
{
    return returnReduce(!selection_.cells(region_.fe(), bad).empty(), orOp<bool>());
}


void Foam::regionRemeshing::report(const labelHashSet& bad, const string& why) const
{
    const feMesh& fe = region_.fe();
    const List<qualityMeasure>& measures = qualityMeasures();
    const scalarList worst(worstOf(fe, present()));
    const label nCells = returnReduce(region_.mesh().nCells(), sumOp<label>());
    const label nBad = returnReduce(bad.size(), sumOp<label>());
    const label n = returnReduce(selection_.cells(fe, bad).size(), sumOp<label>());
    Info<< nl << "Region " << region_.name() << ":";
    forAll(measures, m) Info<< ' ' << measures[m].extreme << ' ' << fourDigits(worst[m]);
    Info<< nl << "Criteria: " << (why.empty() ? "nothing" : why.c_str()) << nl
        << nBad << " bad cells, " << n << " of " << nCells << " to be exchanged" << nl << endl;
}


void Foam::regionRemeshing::toConstant()
{
    region_.mesh().setInstance(region_.mesh().time().constant());
    memory_.forgetPoints0();
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

Foam::remeshing::remeshing(coupledSystem& system)
{
    forAll(system.regions(), r)
    {
        if (!regionRemeshing::wanted(system.regions()[r])) continue;
        regions_.append(new regionRemeshing(system, r));
        regions_.last().checkStart();
    }
}


bool Foam::remeshing::update(const bool inverted)
{
    bool any = false;
    for (regionRemeshing& region : regions_) any = region.update(inverted) || any;
    return any;
}


// ************************************************************************* //
