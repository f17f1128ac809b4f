/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feRegion.H"
#include "points0MotionSolver.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(feRegion, 0);
    defineRunTimeSelectionTable(feRegion, mesh);
}


const char* Foam::feRegion::outcomeName(const label o)
{
    static const char* names[] =
        {"converged", "maxIterations", "diverged", "invertedElement", "singular"};
    return names[o];
}


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
        name, instance, mesh, IOobject::MUST_READ_IF_MODIFIED, IOobject::NO_WRITE
    );
}


Foam::IOdictionary Foam::feRegion::readSchemes(const fvMesh& mesh)
{
    IOobject io(dictObject("feSchemes", mesh.time().system(), mesh));
    io.registerObject() = false;
    return IOdictionary(io);
}


void Foam::feRegion::addVector(const vectorField& f, scalarField& R) const
{
    forAll(f, n)
    {
        const label start = map_->start(systemNode_[n]);
        for (label a = 0; a < fe().dim(); ++a) R[start + a] += f[n][fe().axis(a)];
    }
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
    fe_
    (
        new feMesh
        (
            mesh, order, schemes_,
            pointIOField(points0MotionSolver::points0IO(mesh))
        )
    ),
    g_
    (
        IOobject
        (
            "g", mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        ),
        dimensionedVector("g", dimAcceleration, Zero)
    ),
    map_(nullptr),
    force_(fe_->nNodes(), Zero),
    minDetJ_(GREAT)
{}


Foam::autoPtr<Foam::feRegion> Foam::feRegion::New
(
    const word& type,
    const dictionary& where,
    fvMesh& mesh
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
    return cstrIter()(mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::feRegion::connect
(
    const labelUList& systemNode,
    const nodeMap& map
)
{
    systemNode_ = systemNode;
    map_ = &map;
    scatter_.clear();
    for (const elementBlock& block : fe().blocks())
    {
        scatter_.append(new elementScatter(block, systemNode_, systemNode_));
    }
}


// ************************************************************************* //
