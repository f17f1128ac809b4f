/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallStiffness.H"
#include "laplaceMotion.H"
#include "feValues.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace meshStiffnesses
{
    defineTypeNameAndDebug(wallStiffness, 0);
    addToRunTimeSelectionTable(meshStiffness, wallStiffness, dictionary);

namespace
{

//- Exponent p, number of linear problems, least kappa over the greatest
const scalar power = 2, least = 1e-4;
const label nSolutions = 6;


//- A scalar at the nodes, given at the walls
class amplitude
{
    const feMesh& fe_;
    const fieldLayout layout_;
    nodeMap map_;
    const fieldUnknowns unknowns_;
    dofConstraints constraints_;
    PtrList<elementScatter> scatter_;
    autoPtr<feMatrix> K_;
    autoPtr<feFactors> factors_;
    scalarField walls_, b_, phi_;

    label unknown(const label node) const { return unknowns_.start(0, node); }

public:

    amplitude(const feMesh& fe, const motionWalls& walls)
    :
        fe_(fe),
        layout_(fe, {{"amplitude", fieldLayout::kind::SCALAR, fieldLayout::support::NODES, dimless}}),
        map_(layout_.keys(), fieldUnknowns::counts(layout_)),
        unknowns_(layout_, map_),
        constraints_(map_),
        walls_(map_.nUnknowns(), 0),
        b_(walls_),
        phi_(walls_)
    {
        for (const label n : walls.moving) walls_[unknown(n)] = 1;
        for (const labelList* nodes : {&walls.moving, &walls.resting})
        {
            for (const label n : *nodes) constraints_.fix(unknown(n));
        }
        constraints_.close();
        for (const elementBlock& block : fe.blocks()) scatter_.append(new elementScatter(block, unknowns_));
        K_.reset(new feMatrix(map_, map_, &constraints_, scatter_));
        factors_.reset(new feFactors(map_, K_(), walls.solver));
    }

    //- Whether it could be done
    bool solve(const List<scalarField>& kappa)
    {
        K_->clear();
        addLaplacian(K_(), scatter_, fe_, fe_.points(), kappa);
        K_->multiply(walls_, b_);
        map_.sum(b_);
        forAll(b_, i) b_[i] = constraints_.isFree(i) ? -b_[i] : 0;
        if (factors_->factorise() != feLinearSolver::outcome::OK) return false;
        const bool ok = factors_->solve(b_, phi_) == feLinearSolver::outcome::OK;
        phi_ += walls_;
        return ok;
    }

    //- Mean square of grad phi in each element of a block
    scalarField gradients(const label blocki) const
    {
        const elementBlock& block = fe_.blocks()[blocki];
        scalarField g(block.size());
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            if (E::dim != fe_.dim()) return;
            feValues<double, E> values;
            Vec<double, E::dim> x[E::nNodes];
            double phi[E::nNodes];
            forAll(g, e)
            {
                for (int i = 0; i < E::nNodes; ++i)
                {
                    const label n = block.element(e)[i];
                    for (int a = 0; a < E::dim; ++a) x[i][a] = fe_.points()[n][fe_.axis(a)];
                    phi[i] = phi_[unknown(n)];
                }
                scalar sum = 0, volume = 0;
                for (int q = 0; q < values.nQ; ++q)
                {
                    values.reinit(x, q);
                    const auto gradient = values.grad(phi);
                    sum += (gradient & gradient)*values.dV;
                    volume += values.dV;
                }
                g[e] = sum/volume;
            }
        });
        return g;
    }
};

} // End anonymous namespace
} // End namespace meshStiffnesses
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshStiffnesses::wallStiffness::wallStiffness
(
    const feMesh& fe,
    const motionWalls& walls,
    const dictionary&
)
:
    kappa_(fe.blocks().size())
{
    forAll(kappa_, b) kappa_[b] = scalarField(fe.blocks()[b].size(), 1);
    if
    (
        !returnReduce(walls.moving.size(), sumOp<label>())
     || !returnReduce(walls.resting.size(), sumOp<label>())
    ) return;

    amplitude phi(fe, walls);
    for (label k = 0; k < nSolutions && phi.solve(kappa_); ++k)
    {
        List<scalarField> gradients(kappa_.size());
        scalar greatest = VSMALL;
        forAll(kappa_, b)
        {
            gradients[b] = phi.gradients(b);
            for (const scalar g : gradients[b]) greatest = max(greatest, g);
        }
        reduce(greatest, maxOp<scalar>());
        forAll(kappa_, b) forAll(kappa_[b], e)
        {
            const scalar now = max(Foam::pow(gradients[b][e]/greatest, 0.5*power), least);
            kappa_[b][e] = Foam::pow(kappa_[b][e], power/(1 + power))*Foam::pow(now, 1/(1 + power));
        }
    }
}


// ************************************************************************* //
