/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laplaceMotion.H"
#include "meshStiffness.H"
#include "feValues.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(laplaceMotion, 0);
    addToRunTimeSelectionTable(meshMotion, laplaceMotion, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Scalar element matrices, for each component of the one field
template<int n>
static void addComponents
(
    feMatrix& K,
    const elementScatter& scatter,
    const elementBlock& block,
    const label batch,
    const pack (&k)[n][n]
)
{
    const auto add = [&](const auto cmpts)
    {
        constexpr int d = cmpts();
        pack all[n][n][d][d];
        for (int i = 0; i < n; ++i) for (int j = 0; j < n; ++j)
        {
            for (int a = 0; a < d; ++a) for (int b = 0; b < d; ++b)
            {
                all[i][j][a][b] = a == b ? k[i][j] : pack(0.0);
            }
        }
        K.add(scatter, block, batch, &all[0][0][0][0], 0, 0, 1);
    };
    switch (scatter.rows[0].nCmpts)
    {
        case 1: K.add(scatter, block, batch, &k[0][0], 0, 0, 1); break;
        case 2: add(std::integral_constant<int, 2>()); break;
        case 3: add(std::integral_constant<int, 3>()); break;
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::laplaceMotion::makeBoundary(pointVectorField* boundary)
{
    if (!boundary)
    {
        const polyBoundaryMesh& patches = fe_.mesh().boundaryMesh();
        wordList types(patches.size(), "fixedValue");
        forAll(patches, p)
        {
            if (polyPatch::constraintType(patches[p].type())) types[p] = patches[p].type();
        }
        byDefault_.reset
        (
            new pointVectorField
            (
                IOobject("meshDisplacement", fe_.mesh().time().timeName(), fe_.mesh()),
                pointMesh::New(fe_.mesh()),
                dimensionedVector(dimLength, Zero),
                types
            )
        );
        boundary = byDefault_.get();
    }
    boundary_.reset(new nodalBoundary(fe_, *boundary));
}


void Foam::laplaceMotion::number(const fieldLayout::kind kind)
{
    layout_.reset
    (
        new fieldLayout
        (
            fe_,
            {{"meshDisplacement", kind, fieldLayout::support::NODES, dimLength}}
        )
    );
    map_.reset(new nodeMap(layout_->keys(), fieldUnknowns::counts(layout_())));
    unknowns_.reset(new fieldUnknowns(layout_(), map_()));
    constraints_.reset(new dofConstraints(map_()));
}


void Foam::laplaceMotion::constrain()
{
    constraints_->reopen();
    boundary_->constrain(unknowns_(), 0, constraints_());
    for (const label patchi : heldPatches_) for (const label n : fe_.patchNodes(patchi))
    {
        forCmpts(n, [&](const label, const label, const label u) { constraints_->fix(u); });
    }
    constraints_->close();
}


bool Foam::laplaceMotion::uncoupled() const
{
    bool coupled = false;
    for (label n = 0; n < fe_.nNodes(); ++n)
    {
        const bool held = constraints_->isFixed(unknowns_->start(0, n));
        forCmpts(n, [&](const label, const label, const label u)
        {
            coupled = coupled || constraints_->isTied(u) || constraints_->isFixed(u) != held;
        });
    }
    return !returnReduce(coupled, orOp<bool>());
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
            addComponents(K_(), scatter_[blocki], block, batch, K);
        });
    }
}


void Foam::laplaceMotion::assemble(const dictionary& dict)
{
    for (const elementBlock& block : fe_.blocks())
    {
        scatter_.append(new elementScatter(block, unknowns_()));
    }
    K_.reset(new feMatrix(map_(), map_(), constraints_.get(), scatter_, true));

    const List<scalarField> kappa = meshStiffness::elements(fe_, dict);
    forAll(fe_.blocks(), b)
    {
        withElement(fe_.blocks()[b], [&](auto E)
        {
            assembleBlock<decltype(E)>(b, kappa[b]);
        });
    }
}


bool Foam::laplaceMotion::solve(vectorField& u, const bool affine) const
{
    // K x = 0 with what is known of x on the right: values that are given, and
    // what ties add to their masters'
    for (scalarField& x : x_)
    {
        x = 0;
        if (affine) for (const label i : constraints_->slaves()) x[i] = constraints_->b(i);
    }
    forAll(u, n) forCmpts(n, [&](const label c, const label r, const label i)
    {
        if (constraints_->isGiven(i)) x_[r][i] = u[n][c];
    });
    forAll(x_, r)
    {
        K_->multiply(x_[r], b_[r]);
        map_->sum(b_[r]);
        forAll(b_[r], i) b_[r][i] = constraints_->isFree(i) ? -b_[r][i] : 0;
    }
    if (factors_->solve(b_, x_) != feLinearSolver::outcome::OK) return false;

    forAll(u, n) forCmpts(n, [&](const label c, const label r, const label i)
    {
        if (constraints_->isGiven(i)) x_[r][i] = u[n][c];
    });
    for (scalarField& x : x_) affine ? constraints_->impose(x) : constraints_->imposeHomogeneous(x);
    forAll(u, n) forCmpts(n, [&](const label c, const label r, const label i) { u[n][c] = x_[r][i]; });
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::laplaceMotion::laplaceMotion
(
    const feMesh& fe,
    pointVectorField* boundary,
    const labelUList& heldPatches,
    const dictionary& dict,
    const dictionary& solver
)
:
    fe_(fe),
    heldPatches_(heldPatches)
{
    makeBoundary(boundary);
    number(fieldLayout::kind::VECTOR);
    constrain();
    if (uncoupled())
    {
        boolList held(fe_.nNodes());
        forAll(held, n) held[n] = constraints_->isFixed(unknowns_->start(0, n));
        number(fieldLayout::kind::SCALAR);
        forAll(held, n) if (held[n]) constraints_->fix(unknowns_->start(0, n));
        constraints_->close();
    }
    x_.setSize(layout_->nComponents(0) > 1 ? 1 : fe_.dim(), scalarField(map_->nUnknowns()));
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
    forCmpts(node, [&](const label, const label, const label u)
    {
        all = all && constraints_->isGiven(u);
    });
    return all;
}


void Foam::laplaceMotion::renew()
{
    // Without ties there is nothing to renew
    if (layout_->nComponents(0) > 1) constrain();
}


// ************************************************************************* //
