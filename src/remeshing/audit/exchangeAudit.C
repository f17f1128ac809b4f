/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exchangeAudit.H"
#include "elementQuality.H"
#include "feValues.H"
#include "fourDigits.H"
#include "unknownEntries.H"
#include "OFstream.H"
#include "OStringStream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Integrals over the elements of 1, v and v.v/2
static void integrate
(
    const feMesh& fe,
    const vectorField& x,
    const vectorField& v,
    scalar& volume,
    vector& momentum,
    scalar& energy
)
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
                for (int i = 0; i < E::nNodes; ++i) vq += w.N[i]*v[nodes[i]];
                volume += w.dV;
                momentum += vq*w.dV;
                energy += 0.5*(vq & vq)*w.dV;
            }
        }
    });
    reduce(volume, sumOp<scalar>());
    reduce(momentum, sumOp<vector>());
    reduce(energy, sumOp<scalar>());
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

Foam::exchangeAudit::exchangeAudit(const feRegion& region, const labelUList& patches)
:
    nCells(returnReduce(region.mesh().nCells(), sumOp<label>())),
    nNodes(0),
    volume(0),
    momentum(Zero),
    kineticEnergy(0),
    force(Zero),
    forces(0)
{
    const feMesh& fe = region.fe();
    for (label n = 0; n < fe.nNodes(); ++n) nNodes += fe.copies().owned(n);
    reduce(nNodes, sumOp<label>());

    const vectorField x(fe.points() + region.motion().D);
    worst = worstOf(fe, x);
    const vectorField* v = region.state().find<vector>("U");
    integrate(fe, x, v ? *v : region.motion().v, volume, momentum, kineticEnergy);

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
    static const wordList names({"volume", "momentum", "kineticEnergy", "force"});
    return names;
}


Foam::scalarList Foam::exchangeAudit::changes(const exchangeAudit& b) const
{
    const auto relative = [](const scalar change, const scalar size) { return change/max(size, VSMALL); };
    return
    {
        relative(mag(volume - b.volume), b.volume),
        relative(mag(momentum - b.momentum), Foam::sqrt(2*b.kineticEnergy*b.volume)),
        relative(mag(kineticEnergy - b.kineticEnergy), b.kineticEnergy),
        relative(mag(force - b.force), b.forces)
    };
}


Foam::scalarList Foam::exchangeTable::readBounds(const dictionary& dict)
{
    const wordList& names = exchangeAudit::changeNames();
    reportUnknownEntries(dict, names);
    scalarList bounds;
    for (const word& name : names)
    {
        bounds.append(dict.getOrDefault<scalar>(name, name == "volume" ? 1e-9 : GREAT));
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
