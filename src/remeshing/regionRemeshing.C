/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionRemeshing.H"
#include "simplexExchange.H"
#include "meshBackup.H"
#include "gatherAll.H"
#include "followingMotion.H"
#include "hasMultipliers.H"
#include "elementQuality.H"
#include "clockValue.H"
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


static vectorField present(const feRegion& region)
{
    return region.fe().points() + region.motion().D;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


Foam::string Foam::regionRemeshing::makeMesh
(
    const labelUList& cells,
    const vectorField& x,
    const elementSearch& search,
    meshExchange& e
) const
{
    const feMesh& fe = region_.fe();
    labelList nodes;
    const simplexMesh old(simplicesOf(fe, x, cells, nodes));
    simplexMesh now(old);
    const auto size = [&](const point& p)
    {
        point at = Zero;
        for (label a = 0; a < fe.dim(); ++a) at[fe.axis(a)] = p[a];
        labelList vertices;
        scalarList N;
        search.vertexWeights(search.find(at, GREAT), vertices, N);
        scalar s = 0;
        forAll(vertices, i) s += N[i]*memory_.size(vertices[i]);
        return s;
    };
    string failure;
    if (!cells.empty()) failure = remesher_->remesh(old, size, now);
    if (!failure.empty()) return failure;
    failure = simplexExchange(fe, fe.movedPoints(region_.motion().D), cells).make(now, nodes, e);
    if (!failure.empty()) return failure;

    // New cells have the old one at their centre
    label k = 0;
    for (label& c : e.cellMap)
    {
        if (c >= 0) continue;
        point centre = Zero;
        for (const label p : now.cells[k]) for (label a = 0; a < fe.dim(); ++a)
        {
            centre[fe.axis(a)] += now.points[p][a]/now.cells[k].size();
        }
        const elementSearch::place place(search.find(centre, GREAT));
        if (place.block < 0) return "a new cell is not in the old mesh";
        c = search.cell(place);
        ++k;
    }
    return "";
}


void Foam::regionRemeshing::apply
(
    meshExchange& e,
    const label nKept,
    const vectorField& x,
    const elementSearch& search
)
{
    fvMesh& mesh = region_.mesh();
    const feMesh& old = region_.fe();

    // Kept cells come first, in their order
    const labelList pointMap(e.pointMap), cellMap(e.cellMap);
    boolList made(cellMap.size(), false);
    forAll(made, c) made[c] = c >= nKept;
    const scalarField size(memory_.sizes());

    e.apply(mesh);
    stateMap map;
    map.points0 = mesh.points();
    const feMesh now(mesh, old.order(), feRegion::readSchemes(mesh), map.points0);
    mapping_->map({old, x, search, pointMap, cellMap, made}, now, map);
    discretise(map);
    memory_.setSizes(map.vertices(size));

    // Interpolated rates of the old mesh's motion are not those of the new one's,
    // which would oscillate about its own
    if (region_.follower()) region_.follower()->followedAtStart();
}


void Foam::regionRemeshing::discretise(const stateMap& map)
{
    List<const stateMap*> maps(system_.regions().size(), nullptr);
    maps[regioni_] = &map;
    system_.discretise(maps);
    memory_.setPoints0(map.points0);
}


bool Foam::regionRemeshing::projects() const
{
    if (!mapping_->projects()) return false;
    const auto* fluid = dynamic_cast<const hasMultipliers*>(&region_);
    const word elements(feRegion::readSchemes(region_.mesh()).get<word>("elements"));
    if (fluid && !fluid->multipliers().empty() && elements != "equalOrder") return true;
    Info<< "    The state is interpolated, not projected: the fluid has a bulk modulus or equalOrder" << nl;
    return false;
}


Foam::exchangeAudit Foam::regionRemeshing::audit()
{
    system_.linearise();
    return exchangeAudit(region_, patches_);
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
    const vectorField x(present(region_)), dx(inverted ? vectorField(deltaT*motion.v) : vectorField(motion.D - motion.D0));
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
    const scalarList worst(worstOf(fe, present(region_)));
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


bool Foam::regionRemeshing::exchange(const string& why, const labelHashSet& bad)
{
    const clockValue start(true);
    Info<< "Remeshing of region " << region_.name() << " at time " << region_.mesh().time().timeName()
        << ": " << why.c_str() << nl;
    const vectorField x(present(region_));
    const elementSearch search(region_.fe(), x);
    const labelList cells(selection_.cells(region_.fe(), bad));
    if (!any(bad))
    {
        Info<< "    No cell that may be exchanged is bad: the mesh stays" << nl << endl;
        return false;
    }
    meshExchange e;
    const string mine(makeMesh(cells, x, search, e));
    for (const string& failure : gatherAll<string>(List<string>(1, mine)))
    {
        if (failure.empty()) continue;
        WarningInFunction
            << "Region " << region_.name() << ": " << failure.c_str() << ". The old mesh stays" << endl;
        return false;
    }
    const exchangeAudit before(audit());
    meshBackup backup(region_);
    const scalarField sizes(memory_.sizes());
    apply(e, region_.mesh().nCells() - cells.size(), x, search);
    const bool projected = !projects() || system_.project();
    const exchangeAudit after(audit());
    table_.report(before, after, start.elapsed());
    const string broken(projected ? table_.broken(before, after) : "the projection of the velocities has failed");
    if (!broken.empty())
    {
        WarningInFunction
            << "Region " << region_.name() << ": " << broken.c_str() << ". The old mesh is put back" << endl;
        backup.restoreMesh(region_.mesh(), e);
        discretise(backup.map());
        region_.state().set(backup.state());
        memory_.setSizes(sizes);
        return false;
    }
    region_.derive();
    return true;
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
