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
#include "cellSet.H"
#include "IOobjectList.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(meshStiffness, 0);
    defineRunTimeSelectionTable(meshStiffness, dictionary);

namespace
{

elementGeometry geometry
(
    const feMesh& fe,
    const label blocki,
    const label e,
    const vectorField& points
)
{
    elementGeometry g{blocki, e, Zero, 0, 0, 0};
    const elementBlock& block = fe.blocks()[blocki];
    withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        if (E::dim != fe.dim()) return;
        feValues<double, E> values;
        Vec<double, E::dim> x[E::nNodes];
        const label* n = block.element(e);
        point centre = Zero;
        for (int i = 0; i < E::nNodes; ++i)
        {
            for (int a = 0; a < E::dim; ++a) x[i][a] = points[n[i]][fe.axis(a)];
            if (i >= E::nVertices) continue;
            g.centre += fe.points()[n[i]]/E::nVertices;
            centre += points[n[i]]/E::nVertices;
        }
        for (int i = 0; i < E::nVertices; ++i) g.radius += mag(points[n[i]] - centre)/E::nVertices;
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


scalar readFactor(const entry& e, const char* kind, const char* keyword, const dictionary& dict)
{
    const scalar factor = e.isStream() ? readScalar(e.stream()) : 0;
    if (!(factor > 0 && factor < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "The factor of " << kind << ' ' << e.keyword() << " under " << keyword
            << " is no number > 0" << exit(FatalIOError);
    }
    return factor;
}


//- Call f(entry, factor, cells) for the cellSets of a dictionary
template<class F>
void forCellSets(const polyMesh& mesh, const dictionary& dict, const F& f)
{
    const dictionary sets(subDictOrEmpty(dict, "cellSets"));
    if (sets.empty()) return;
    const IOobjectList found
    (
        mesh, mesh.facesInstance(),
        polyMesh::meshSubDir/"sets"
    );
    for (const entry& set : sets)
    {
        if (!returnReduce(found.cfindObject<cellSet>(set.keyword()) != nullptr, orOp<bool>()))
        {
            FatalIOErrorInFunction(dict)
                << "Region " << mesh.name() << " has no cellSet '" << set.keyword()
                << "'. Its cellSets are " << found.sortedNames<cellSet>() << exit(FatalIOError);
        }
        f(readFactor(set, "cellSet", "cellSets", dict), cellSet(mesh, set.keyword()).sortedToc());
    }
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::meshStiffness> Foam::meshStiffness::New
(
    const feMesh& fe,
    const motionWalls& walls,
    const dictionary& dict,
    const wordList& furtherEntries
)
{
    const word type(dict.lookupOrDefault<word>("stiffness", "auto"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "stiffness", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    autoPtr<meshStiffness> stiffness(cstrIter()(fe, walls, dict));
    stiffness->fe_ = &fe;
    stiffness->readFactors(fe, dict);

    wordList entries({"motionSolver", "stiffness", "zones", "cellSets"});
    entries.append(stiffness->entries());
    entries.append(furtherEntries);
    reportUnknownEntries(dict, entries);
    return stiffness;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::meshStiffness::readFactors(const feMesh& fe, const dictionary& dict)
{
    const polyMesh& mesh = fe.mesh();
    factor_ = scalarField(mesh.nCells(), 1);
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
        const scalar zoneFactor = readFactor(zone, "cellZone", "zones", dict);
        for (const label celli : mesh.cellZones()[zonei]) factor_[celli] *= zoneFactor;
    }
    forCellSets(mesh, dict, [&](const scalar setFactor, const labelList& cells)
    {
        for (const label celli : cells) factor_[celli] *= setFactor;
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::scalarField> Foam::meshStiffness::elements(const vectorField& x) const
{
    List<List<elementGeometry>> geometries(fe_->blocks().size());
    scalar volume = 0;
    label n = 0;
    forAll(geometries, b)
    {
        geometries[b].setSize(fe_->blocks()[b].size());
        forAll(geometries[b], e)
        {
            geometries[b][e] = geometry(*fe_, b, e, x);
            volume += geometries[b][e].volume;
            ++n;
        }
    }
    reduce(volume, sumOp<scalar>());
    reduce(n, sumOp<label>());

    List<scalarField> kappa(geometries.size());
    forAll(kappa, b)
    {
        kappa[b].setSize(geometries[b].size());
        forAll(kappa[b], e)
        {
            elementGeometry& g = geometries[b][e];
            g.meanVolume = volume/n;

            // An element that is inverted for now is a very small one
            g.volume = max(g.volume, 1e-6*g.meanVolume);
            kappa[b][e] = factor_[fe_->blocks()[b].cells[e]]*(*this)(g);
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
    uniform(const feMesh&, const motionWalls&, const dictionary&) {}
    wordList entries() const { return {}; }
    scalar operator()(const elementGeometry&) const { return 1; }
};


class inverseVolume : public meshStiffness
{
    const scalar exponent_;

public:

    TypeName("inverseVolume");
    inverseVolume(const feMesh&, const motionWalls&, const dictionary& dict)
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
    distortion(const feMesh& fe, const motionWalls&, const dictionary& dict)
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
    inverseDistance(const feMesh& fe, const motionWalls&, const dictionary& dict)
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


class product : public meshStiffness
{
    PtrList<meshStiffness> factors_;

public:

    TypeName("product");
    product(const feMesh& fe, const motionWalls& walls, const dictionary& dict)
    {
        const PtrList<dictionary> dicts(dict.lookup("factors"));
        for (const dictionary& factor : dicts) factors_.append(New(fe, walls, factor, {}).ptr());
    }
    wordList entries() const { return {"factors"}; }
    scalar operator()(const elementGeometry& g) const
    {
        scalar p = 1;
        for (const meshStiffness& factor : factors_) p *= factor(g);
        return p;
    }
};


#define makeMeshStiffness(Type)                                                \
    defineTypeNameAndDebug(Type, 0);                                           \
    addToRunTimeSelectionTable(meshStiffness, Type, dictionary)

makeMeshStiffness(uniform);
makeMeshStiffness(inverseVolume);
makeMeshStiffness(distortion);
makeMeshStiffness(inverseDistance);
makeMeshStiffness(product);

} // End namespace meshStiffnesses
} // End namespace Foam


// ************************************************************************* //
