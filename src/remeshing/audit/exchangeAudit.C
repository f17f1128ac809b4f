/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exchangeAudit.H"
#include "elementQuality.H"
#include "hasDensity.H"
#include "simplexQuality.H"
#include "feValues.H"
#include "fourDigits.H"
#include "unknownEntries.H"
#include "OFstream.H"
#include "OStringStream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Integrals over the elements of 1, rho, rho v and rho v.v/2
static void integrate(const feMesh& fe, const vectorField& x, const vectorField& v, const scalarField& rho, exchangeAudit& sum)
{
    for (const elementBlock& block : fe.blocks()) withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        constexpr int d = E::dim;
        if (d != fe.dim()) return;
        feValues<double, E> w;
        Vec<double, d> xe[E::nNodes];
        for (label e = 0; e < block.size(); ++e)
        {
            const label* nodes = block.element(e);
            for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < d; ++a) xe[i][a] = x[nodes[i]][fe.axis(a)];
            for (int q = 0; q < w.nQ; ++q)
            {
                w.reinit(xe, q);
                vector vq = Zero;
                scalar dm = 0;
                for (int i = 0; i < E::nNodes; ++i)
                {
                    vq += w.N[i]*v[nodes[i]];
                    dm += w.N[i]*rho[nodes[i]]*w.dV;
                }
                sum.volume += w.dV;
                sum.mass += dm;
                sum.momentum += vq*dm;
                sum.kineticEnergy += 0.5*(vq & vq)*dm;
            }
        }
    });
    reduce(sum.volume, sumOp<scalar>());
    reduce(sum.mass, sumOp<scalar>());
    reduce(sum.momentum, sumOp<vector>());
    reduce(sum.kineticEnergy, sumOp<scalar>());
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarList Foam::worstOf(const feMesh& fe, const vectorField& x)
{
    const List<qualityMeasure>& measures = qualityMeasures();
    const elementQualities now(qualities(fe, x)), reference(qualities(fe, fe.points()));
    scalarList all;
    forAll(measures, m)
    {
        const qualityMeasure& measure = measures[m];
        scalar w = measure.smallIsBad ? GREAT : -GREAT;
        forAll(now, b) forAll(now[b], e)
        {
            const scalar value = measure.of(now[b][e], reference[b][e]);
            if (measure.worse(value, w)) w = value;
        }
        measure.smallIsBad ? reduce(w, minOp<scalar>()) : reduce(w, maxOp<scalar>());
        all.append(w);
    }
    return all;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exchangeAudit::exchangeAudit
(
    const feRegion& region,
    const labelUList& patches,
    const labelUList& oldVertices
)
:
    nCells(returnReduce(region.mesh().nCells(), sumOp<label>())),
    nNodes(0),
    volume(0),
    mass(0),
    momentum(Zero),
    kineticEnergy(0),
    force(Zero),
    forces(0),
    old(oldVertices)
{
    const feMesh& fe = region.fe();
    for (label n = 0; n < fe.nNodes(); ++n) nNodes += fe.copies().owned(n);
    reduce(nNodes, sumOp<label>());

    const vectorField x(fe.points() + region.motion().D);
    worst = worstOf(fe, x);
    const vectorField* v = region.state().find<vector>("U");
    const auto* dense = dynamic_cast<const hasDensity*>(&region);
    const scalarField rho(dense ? dense->density()() : scalarField(fe.nNodes(), 1));
    integrate(fe, x, v ? *v : region.motion().v, rho, *this);
    const scalarField* p = region.state().find<scalar>("p");
    if (p && p->size() == fe.nVertices()) pressure = *p;

    // The rank's part of it
    labelHashSet boundary;
    for (const label patchi : patches) boundary.insert(fe.patchNodes(patchi));
    for (const label n : boundary.sortedToc())
    {
        force += region.force()[n];
        forces += mag(region.force()[n]);
    }
    reduce(force, sumOp<vector>());
    reduce(forces, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::wordList& Foam::exchangeAudit::changeNames()
{
    static const wordList names
    ({
        "volume", "mass", "momentum", "kineticEnergy", "force", "meanPressure", "pressure"
    });
    return names;
}


Foam::scalarList Foam::exchangeAudit::changes(const exchangeAudit& b) const
{
    const auto relative = [](const scalar change, const scalar size) { return change/max(size, VSMALL); };
    const Pair<scalar> p(pressureChanges(b));
    return
    {
        relative(mag(volume - b.volume), b.volume),
        relative(mag(mass - b.mass), b.mass),
        relative(mag(momentum - b.momentum), Foam::sqrt(2*b.kineticEnergy*b.mass)),
        relative(mag(kineticEnergy - b.kineticEnergy), b.kineticEnergy),
        relative(mag(force - b.force), b.forces),
        p.first(), p.second()
    };
}


Foam::Pair<Foam::scalar> Foam::exchangeAudit::pressureChanges(const exchangeAudit& b) const
{
    scalar sum = 0, largest = 0;
    label n = 0;
    forAll(pressure, i)
    {
        if (old[i] < 0) continue;
        const scalar change = mag(pressure[i] - b.pressure[old[i]]);
        sum += change;
        largest = max(largest, change);
        ++n;
    }
    reduce(sum, sumOp<scalar>());
    reduce(largest, maxOp<scalar>());
    reduce(n, sumOp<label>());

    // Of a pressure that is nil but for round-off, the flow's energy tells the size
    const scalar range = max(gMax(b.pressure) - gMin(b.pressure), 1e-9*b.kineticEnergy/b.volume);
    if (!n || range <= 0) return Pair<scalar>(0, 0);
    return Pair<scalar>(sum/n/range, largest/range);
}


Foam::scalarList Foam::exchangeTable::readBounds(const dictionary& dict)
{
    wordList names(exchangeAudit::changeNames());
    names.append("scaledJacobian");
    reportUnknownEntries(dict, names);
    scalarList bounds;
    for (const word& name : names)
    {
        const scalar usual = name == "volume" ? 1e-9 : name == "scaledJacobian" ? 0.1 : GREAT;
        bounds.append(dict.getOrDefault<scalar>(name, usual));
        if (bounds.last() > 0) continue;
        FatalIOErrorInFunction(dict)
            << "The bound on " << name << " is " << bounds.last() << ", expected a number > 0"
            << exit(FatalIOError);
    }
    return bounds;
}


Foam::exchangeTable::exchangeTable(const feRegion& region, const dictionary& bounds)
:
    region_(region),
    bounds_(readBounds(bounds))
{}


Foam::string Foam::exchangeTable::worse(const simplexMesh& old, const simplexMesh& now) const
{
    const scalar before = leastScaledJacobian(old), after = leastScaledJacobian(now);
    if (after > 0 && after >= min(0.9*before, bounds_.last())) return "";
    OStringStream os;
    os  << "the worst of the new cells has the scaled Jacobian " << after << ", that of those there are "
        << before << ", and its bound is " << bounds_.last();
    return os.str();
}


Foam::string Foam::exchangeTable::broken(const exchangeAudit& before, const exchangeAudit& after) const
{
    const scalarList changes(after.changes(before));
    forAll(changes, i)
    {
        if (changes[i] <= bounds_[i]) continue;
        OStringStream os;
        os  << "the change of " << exchangeAudit::changeNames()[i] << " is " << changes[i]
            << ", its bound " << bounds_[i];
        return os.str();
    }
    return "";
}


void Foam::exchangeTable::report
(
    const exchangeAudit& before,
    const exchangeAudit& after,
    const scalar seconds
)
{
    const List<qualityMeasure>& measures = qualityMeasures();
    const wordList& names = exchangeAudit::changeNames();
    const scalarList changes(after.changes(before));

    Info<< "    cells " << before.nCells << " -> " << after.nCells << ", nodes " << before.nNodes
        << " -> " << after.nNodes << ", " << fourDigits(seconds) << " s" << nl << "   ";
    forAll(measures, m)
    {
        Info<< ' ' << measures[m].extreme << ' ' << fourDigits(before.worst[m]) << " -> "
            << fourDigits(after.worst[m]) << (m + 1 < measures.size() ? "," : "");
    }
    Info<< nl << "    relative changes:";
    forAll(names, i) Info<< ' ' << names[i] << ' ' << fourDigits(changes[i]);
    Info<< nl << endl;

    if (!Pstream::master()) return;
    const Time& time = region_.mesh().time();
    if (!file_.valid())
    {
        const fileName dir
        (
            time.globalPath()/"postProcessing"/"remeshing"/region_.name()/Time::timeName(time.startTime().value())
        );
        mkDir(dir);
        file_.reset(new OFstream(dir/"remeshing.dat"));
        Ostream& os = file_();
        os << "# Time cellsBefore cells nodesBefore nodes seconds";
        for (const qualityMeasure& m : measures) os << ' ' << m.extreme << "Before " << m.extreme;
        for (const word& name : names) os << ' ' << name << "Change";
        os << endl;
    }
    Ostream& os = file_();
    os  << time.timeName() << ' ' << before.nCells << ' ' << after.nCells << ' ' << before.nNodes
        << ' ' << after.nNodes << ' ' << seconds;
    forAll(measures, m) os << ' ' << before.worst[m] << ' ' << after.worst[m];
    for (const scalar c : changes) os << ' ' << c;
    os << endl;
}


// ************************************************************************* //
