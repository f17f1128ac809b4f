/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshStiffness.H"
#include "addToRunTimeSelectionTable.H"
#include "feValues.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"
#include "Pstream.H"
#include "ListOps.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(meshStiffness, 0);
    defineRunTimeSelectionTable(meshStiffness, dictionary);

namespace
{

elementGeometry geometry(const feMesh& fe, const elementBlock& block, const label e)
{
    elementGeometry g{Zero, 0, 0, 0};
    withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        if (E::dim != fe.dim()) return;
        feValues<double, E> values;
        Vec<double, E::dim> x[E::nNodes];
        const label* n = block.element(e);
        for (int i = 0; i < E::nNodes; ++i)
        {
            for (int a = 0; a < E::dim; ++a) x[i][a] = fe.points()[n[i]][fe.axis(a)];
            if (i < E::nVertices) g.centre += fe.points()[n[i]]/E::nVertices;
        }
        for (int i = 0; i < E::nVertices; ++i) g.radius += mag(fe.points()[n[i]] - g.centre)/E::nVertices;
        for (int q = 0; q < values.nQ; ++q)
        {
            values.reinit(x, q);
            g.volume += values.dV;
        }
    });
    return g;
}


//- Power of a measure that spans some decades: a factor stays a number
scalar readExponent(const dictionary& dict)
{
    const scalar exponent = dict.lookupOrDefault<scalar>("exponent", 1);
    if (!(exponent >= 0 && exponent <= 10))
    {
        FatalIOErrorInFunction(dict)
            << "exponent is " << exponent << ", expected a number from 0 to 10"
            << exit(FatalIOError);
    }
    return exponent;
}


scalar readFactor(const entry& zone, const dictionary& dict)
{
    const scalar factor = zone.isStream() ? readScalar(zone.stream()) : 0;
    if (!(factor > 0 && factor < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "The factor of cellZone " << zone.keyword() << " under zones is no"
            << " number > 0" << exit(FatalIOError);
    }
    return factor;
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::meshStiffness> Foam::meshStiffness::New
(
    const feMesh& fe,
    const dictionary& dict
)
{
    const word type(dict.lookupOrDefault<word>("stiffness", "inverseVolume"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "stiffness", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    autoPtr<meshStiffness> stiffness(cstrIter()(fe, dict));

    wordList entries({"motionSolver", "stiffness", "zones"});
    entries.append(stiffness->entries());
    reportUnknownEntries(dict, entries);
    return stiffness;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::scalarField> Foam::meshStiffness::elements
(
    const feMesh& fe,
    const dictionary& dict
)
{
    const autoPtr<meshStiffness> stiffness = New(fe, dict);
    const polyMesh& mesh = fe.mesh();

    scalarField factor(mesh.nCells(), 1);
    const dictionary zones(subDictOrEmpty(dict, "zones"));
    for (const entry& zone : zones)
    {
        const label zonei = mesh.cellZones().findZoneID(zone.keyword());
        if (zonei < 0)
        {
            FatalIOErrorInFunction(dict)
                << "Region " << mesh.name() << " has no cellZone '"
                << zone.keyword() << "'. Its cellZones are "
                << mesh.cellZones().names() << exit(FatalIOError);
        }
        const scalar zoneFactor = readFactor(zone, dict);
        for (const label celli : mesh.cellZones()[zonei]) factor[celli] = zoneFactor;
    }

    List<List<elementGeometry>> geometries(fe.blocks().size());
    scalar volume = 0;
    label n = 0;
    forAll(fe.blocks(), b)
    {
        const elementBlock& block = fe.blocks()[b];
        geometries[b].setSize(block.size());
        forAll(geometries[b], e)
        {
            geometries[b][e] = geometry(fe, block, e);
            volume += geometries[b][e].volume;
            ++n;
        }
    }
    reduce(volume, sumOp<scalar>());
    reduce(n, sumOp<label>());

    List<scalarField> kappa(fe.blocks().size());
    forAll(kappa, b)
    {
        kappa[b].setSize(geometries[b].size());
        forAll(kappa[b], e)
        {
            elementGeometry& g = geometries[b][e];
            g.meanVolume = volume/n;
            kappa[b][e] = factor[fe.blocks()[b].cells[e]]*(*stiffness)(g);
        }
    }
    return kappa;
}


// * * * * * * * * * * * * * * * * * Models  * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace meshStiffnesses
{

class uniform : public meshStiffness
{
public:
    TypeName("uniform");
    uniform(const feMesh&, const dictionary&) {}
    wordList entries() const { return {}; }
    scalar operator()(const elementGeometry&) const { return 1; }
};


class inverseVolume : public meshStiffness
{
    const scalar exponent_;

public:

    TypeName("inverseVolume");
    inverseVolume(const feMesh&, const dictionary& dict)
    :
        exponent_(readExponent(dict))
    {}
    wordList entries() const { return {"exponent"}; }
    scalar operator()(const elementGeometry& g) const
    {
        return Foam::pow(g.meanVolume/g.volume, exponent_);
    }
};


class distortion : public meshStiffness
{
    const scalar exponent_, dim_;

public:

    TypeName("distortion");
    distortion(const feMesh& fe, const dictionary& dict)
    :
        exponent_(readExponent(dict)),
        dim_(fe.dim())
    {}
    wordList entries() const { return {"exponent"}; }
    scalar operator()(const elementGeometry& g) const
    {
        return Foam::pow(Foam::pow(g.radius, dim_)/g.volume, exponent_);
    }
};


class inverseDistance : public meshStiffness
{
    const scalar exponent_, dim_;

    //- Nodes of the patches, of all ranks
    pointField wall_;
    autoPtr<indexedOctree<treeDataPoint>> tree_;

public:

    TypeName("inverseDistance");
    inverseDistance(const feMesh& fe, const dictionary& dict)
    :
        exponent_(readExponent(dict)),
        dim_(fe.dim())
    {
        List<pointField> points(Pstream::nProcs());
        for (const label patchi : fe.patchIndices(dict.get<wordRes>("patches"), dict))
        {
            points[Pstream::myProcNo()].append(pointField(fe.points(), fe.patchNodes(patchi)));
        }
        Pstream::gatherList(points);
        Pstream::scatterList(points);
        wall_ = ListListOps::combine<pointField>(points, accessOp<pointField>());
        treeBoundBox bb(wall_);
        bb.inflate(1e-3);
        tree_.reset(new indexedOctree<treeDataPoint>(treeDataPoint(wall_), bb, 10, 10, 3));
    }

    wordList entries() const { return {"exponent", "patches"}; }

    scalar operator()(const elementGeometry& g) const
    {
        const scalar size = Foam::pow(g.meanVolume, 1/dim_);
        const pointIndexHit hit = tree_->findNearest(g.centre, sqr(GREAT));
        return Foam::pow(size/max(mag(g.centre - hit.hitPoint()), 0.1*size), exponent_);
    }
};


#define makeMeshStiffness(Type)                                                \
    defineTypeNameAndDebug(Type, 0);                                           \
    addToRunTimeSelectionTable(meshStiffness, Type, dictionary)

makeMeshStiffness(uniform);
makeMeshStiffness(inverseVolume);
makeMeshStiffness(distortion);
makeMeshStiffness(inverseDistance);

} // End namespace meshStiffnesses
} // End namespace Foam


// ************************************************************************* //
