/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feRegion.H"
#include "points0MotionSolver.H"
#include "feValues.H"
#include "gatherAll.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(feRegion, 0);
    defineRunTimeSelectionTable(feRegion, mesh);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The region's own body acceleration, or else that of the case
static IOobject gObject(const fvMesh& mesh)
{
    IOobject own
    (
        "g", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
    );
    if (own.typeHeaderOk<uniformDimensionedVectorField>()) return own;
    return IOobject
    (
        "g", mesh.time().constant(), mesh.time(), IOobject::READ_IF_PRESENT, IOobject::NO_WRITE,
        false
    );
}

} // End namespace Foam


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::feRegion::dictObject
(
    const word& name,
    const fileName& instance,
    const fvMesh& mesh
)
{
    return IOobject
    (
        name, instance, mesh, IOobject::MUST_READ, IOobject::NO_WRITE
    );
}


Foam::IOdictionary Foam::feRegion::readSchemes(const fvMesh& mesh)
{
    IOobject io(dictObject("feSchemes", mesh.time().system(), mesh));
    io.registerObject() = false;
    return IOdictionary(io);
}


Foam::scalar Foam::feRegion::stageTime() const
{
    const feTimeScheme& ts = timeScheme();
    return mesh_.time().value() - (1 - ts.alphaF())*ts.deltaT();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feRegion::feRegion(fvMesh& mesh, const label order)
:
    regIOobject
    (
        IOobject
        (
            "feRegion", mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    schemes_(dictObject("feSchemes", mesh.time().system(), mesh)),
    timeScheme_(feTimeScheme::New(schemes_.subDict("timeScheme"))),
    order_(order),
    g_
    (
        gObject(mesh),
        dimensionedVector("g", dimAcceleration, Zero)
    ),
    points0_(pointIOField(points0MotionSolver::points0IO(mesh))),
    fe_(new feMesh(mesh, order, schemes_, points0_)),
    minDetJ_(GREAT)
{
    if (g_.dimensions() != dimAcceleration)
    {
        FatalErrorInFunction
            << "The dimensions of g are " << g_.dimensions() << " in " << g_.objectPath()
            << ", expected " << dimAcceleration << exit(FatalError);
    }
}


Foam::autoPtr<Foam::feRegion> Foam::feRegion::New
(
    const word& type,
    const dictionary& where,
    fvMesh& mesh,
    const dictionary& linearSolver
)
{
    auto cstrIter = meshConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            where, "region solver", type, *meshConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return cstrIter()(mesh, linearSolver);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::feRegion::discretise(const stateMap* map)
{
    if (map)
    {
        // What is on a moving mesh has its present one as reference
        state_.map(*map);
        points0_ = map->points0;
        if (!leads()) for (vectorField* D : {&motion().D, &motion().D0})
        {
            *D = Zero;
            if (map->displacement.size()) *D = map->displacement;
        }
    }
    scatter_.clear();
    unknowns_.clear();

    // The first has been made by the constructor, so that its errors come first
    if (layout_.valid())
    {
        layout_.clear();
        fe_.reset(new feMesh(mesh_, order_, schemes_, points0_));
    }
    layout_.reset(new fieldLayout(fe_(), fields()));
    force_ = vectorField(fe_->nNodes(), Zero);
    makeFields();
}


void Foam::feRegion::number
(
    const nodeMap& map,
    const labelUList& node,
    const UList<labelList>& offset
)
{
    unknowns_.reset(new fieldUnknowns(layout_(), map, node, offset));
}


void Foam::feRegion::connect()
{
    scatter_.clear();
    for (const elementBlock& block : elementBlocks())
    {
        scatter_.append(new elementScatter(block, unknowns_()));
    }
    connected();
}


void Foam::feRegion::colour(const feMatrix& K)
{
    // Masters are met by elements at them, too
    labelHashSet masters;
    List<List<labelList>> nodes(scatter_.size());
    forAll(scatter_, b)
    {
        nodes[b] = K.constrainedNodes(scatter_[b]);
        for (const labelList& m : nodes[b]) masters.insert(m);
    }
    if (masters.empty()) return;
    forAll(scatter_, b)
    {
        const elementScatter& s = scatter_[b];
        forAll(nodes[b], e) for (label i = 0; i < s.nRow; ++i)
        {
            const label node = s.rowNodes[e*s.nRow + i];
            if (masters.found(node)) nodes[b][e].append(node);
        }
        elementBlocks()[b].colour(fe_->nNodes(), nodes[b], unknowns_->map().nNodes());
    }
}


Foam::string Foam::feRegion::worstElement() const
{
    const vectorField x(fe().points() + motion().D);
    scalar worst = GREAT;
    string what;
    for (const elementBlock& block : fe().blocks())
    {
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            if (E::dim != fe().dim()) return;
            feValues<double, E> w;
            Vec<double, E::dim> xe[E::nNodes];
            for (label e = 0; e < block.size(); ++e)
            {
                point centre = Zero;
                for (int i = 0; i < E::nNodes; ++i)
                {
                    const vector& xi = x[block.element(e)[i]];
                    for (int a = 0; a < E::dim; ++a) xe[i][a] = xi[fe().axis(a)];
                    centre += xi/E::nNodes;
                }
                for (int q = 0; q < w.nQ; ++q)
                {
                    w.reinit(xe, q);
                    if (w.detJ >= worst) continue;
                    worst = w.detJ;
                    OStringStream os;
                    os << "cell " << block.cells[e] << " (" << E::name << ") at " << centre;
                    what = os.str();
                }
            }
        });
    }

    // The patch whose nodes have moved most is the one that drives it
    scalar most = SMALL;
    label driver = -1;
    forAll(mesh_.boundaryMesh(), patchi)
    {
        if (polyPatch::constraintType(mesh_.boundaryMesh()[patchi].type())) continue;
        for (const label n : fe().patchNodes(patchi))
        {
            if (mag(motion().D[n]) <= most) continue;
            most = mag(motion().D[n]);
            driver = patchi;
        }
    }
    const scalar mostOfAll = returnReduce(most, maxOp<scalar>());
    const scalar mine = worst;
    reduce(worst, minOp<scalar>());
    if (mine > worst) what.clear();
    for (const string& s : gatherAll<string>(List<string>(1, what))) if (!s.empty()) what = s;
    driver = returnReduce(most == mostOfAll ? driver : -1, maxOp<label>());

    OStringStream os;
    os << what.c_str() << " has a map of determinant " << worst;
    if (driver >= 0)
    {
        os << "; patch " << mesh_.boundaryMesh()[driver].name() << " has moved most, by "
            << mostOfAll << " m";
    }
    return os.str();
}


// ************************************************************************* //
