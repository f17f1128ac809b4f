/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laplaceMotion.H"
#include "meshStiffness.H"
#include "nodalBoundary.H"
#include "feValues.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "clockValue.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::laplaceMotion::constrain
(
    const pointVectorField* boundary,
    const labelUList& heldPatches
)
{
    const labelList node(identity(fe_.nNodes()));
    const polyBoundaryMesh& patches = fe_.mesh().boundaryMesh();
    constraints_.reset(new dofConstraints(map_->nUnknowns()));

    // Only the types of the point field's patches count here
    autoPtr<pointVectorField> byDefault;
    if (!boundary)
    {
        wordList types(patches.size(), "fixedValue");
        forAll(patches, p)
        {
            if (polyPatch::constraintType(patches[p].type())) types[p] = patches[p].type();
        }
        byDefault.reset
        (
            new pointVectorField
            (
                IOobject("meshDisplacement", fe_.mesh().time().timeName(), fe_.mesh()),
                pointMesh::New(fe_.mesh()),
                dimensionedVector(dimLength, Zero),
                types
            )
        );
        boundary = &byDefault();
    }
    nodalBoundary(fe_).constrain(*boundary, node, *map_, *constraints_);

    for (const label patchi : heldPatches)
    {
        for (const label n : fe_.patchNodes(patchi))
        {
            for (label a = 0; a < fe_.dim(); ++a) constraints_->fix(map_->start(n) + a);
        }
    }

    // Ranks without the patch have copies of its nodes
    constraints_->share(map_());
    constraints_->close();
}


void Foam::laplaceMotion::decouple()
{
    const label dim = fe_.dim();
    boolList held(fe_.nNodes());
    bool coupled = false;
    forAll(held, n)
    {
        held[n] = constraints_->isFixed(map_->start(n));
        for (label a = 0; a < dim; ++a)
        {
            const label i = map_->start(n) + a;
            coupled = coupled || constraints_->isTied(i) || constraints_->isFixed(i) != held[n];
        }
    }
    if (returnReduce(coupled, orOp<bool>())) return;

    nUnknowns_ = 1;
    nColumns_ = dim;
    map_.reset(new nodeMap(fe_.key(), labelList(fe_.nNodes(), nUnknowns_)));
    constraints_.reset(new dofConstraints(map_->nUnknowns()));
    forAll(held, n) if (held[n]) constraints_->fix(map_->start(n));
}


template<class E>
void Foam::laplaceMotion::assembleBlock
(
    const label blocki,
    const scalarField& kappa
)
{
    constexpr int dim = E::dim;
    const elementBlock& block = fe_.blocks()[blocki];
    const FixedList<label, 3> axis({fe_.axis(0), fe_.axis(1), fe_.axis(2)});

    #pragma omp parallel
    {
        feValues<pack, E> w;
        Vec<pack, dim> x[E::nNodes];
        pack K[E::nNodes][E::nNodes];

        block.forBatches([&](const label batch)
        {
            gather<E, dim>(block, batch, fe_.points(), axis, x);
            pack k;
            for (int l = 0; l < packSize; ++l) k[l] = kappa[block.lane(batch, l)];

            for (auto& row : K) for (pack& Kij : row) Kij = 0;
            for (int q = 0; q < w.nQ; ++q)
            {
                w.reinit(x, q);
                for (int i = 0; i < E::nNodes; ++i) for (int j = 0; j < E::nNodes; ++j)
                {
                    K[i][j] += k*(w.dN[i] & w.dN[j])*w.dV;
                }
            }
            for (label a = 0; a < nUnknowns_; ++a)
            {
                K_->add
                (
                    scatter_[blocki], block, batch, &K[0][0],
                    E::nNodes, E::nNodes, 1, 1, a, a, 1
                );
            }
        });
    }
}


void Foam::laplaceMotion::assemble(const dictionary& dict)
{
    const labelList node(identity(fe_.nNodes()));
    for (const elementBlock& block : fe_.blocks())
    {
        scatter_.append(new elementScatter(block, node, node));
    }
    K_.reset(new feMatrix(map_(), map_(), constraints_.get(), scatter_));

    const List<scalarField> kappa = meshStiffness::elements(fe_, dict);
    forAll(fe_.blocks(), b)
    {
        withElement(fe_.blocks()[b], [&](auto E)
        {
            assembleBlock<decltype(E)>(b, kappa[b]);
        });
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::laplaceMotion::laplaceMotion
(
    const feMesh& fe,
    const pointVectorField* boundary,
    const labelUList& heldPatches,
    const dictionary& dict,
    const dictionary& solver
)
:
    fe_(fe),
    nUnknowns_(fe.dim()),
    nColumns_(1),
    map_(new nodeMap(fe.key(), labelList(fe.nNodes(), nUnknowns_))),
    solveTime_(0)
{
    constrain(boundary, heldPatches);
    decouple();
    x_.setSize(nColumns_, scalarField(map_->nUnknowns()));
    b_ = x_;
    assemble(dict);
    factors_.reset(new feFactors(map_(), K_(), solver));
    if (factors_->factorise() != feLinearSolver::outcome::OK)
    {
        FatalIOErrorInFunction(dict)
            << "The mesh motion of region " << fe.mesh().name()
            << " cannot be solved: no patch holds its displacement"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::laplaceMotion::given(const label node) const
{
    bool all = true;
    for (label a = 0; a < nUnknowns_; ++a)
    {
        all = all && constraints_->isFixed(map_->start(node) + a);
    }
    return all;
}


void Foam::laplaceMotion::extend(vectorField& u) const
{
    const clockValue timer(true);

    // K u = 0 with the given part of u on the right
    forAll(x_, c)
    {
        scalarField& x = x_[c];
        scalarField& b = b_[c];
        forAll(u, n) for (label a = 0; a < nUnknowns_; ++a)
        {
            const label i = map_->start(n) + a;
            x[i] = constraints_->isFixed(i) ? u[n][fe_.axis(c + a)] : 0;
        }
        K_->multiply(x, b);
        map_->sum(b);
        forAll(b, i) b[i] = constraints_->isFree(i) ? -b[i] : 0;
    }

    factors_->solve(b_, x_);
    forAll(x_, c)
    {
        constraints_->distribute(x_[c]);
        forAll(u, n) for (label a = 0; a < nUnknowns_; ++a)
        {
            const label i = map_->start(n) + a;
            if (!constraints_->isFixed(i)) u[n][fe_.axis(c + a)] = x_[c][i];
        }
    }
    solveTime_ += timer.elapsed();
}


// ************************************************************************* //
