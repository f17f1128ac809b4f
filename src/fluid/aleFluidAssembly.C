/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Residual and tangent of aleFluid: interior, boundary loads, and the
    geometry's derivative.
\*---------------------------------------------------------------------------*/

#include "aleFluid.H"
#include "feValues.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aleFluid::stage()
{
    const feTimeScheme& ts = timeScheme();
    v_.stage(ts, stage_.v, stage_.a);
    q_.stage(ts, stage_.p, stage_.q);
    mesh_D_.stage(ts, stage_.x, stage_.vm, meshAcceleration_);
    stage_.x += fe().points();

    k_.dadv = k_.dqdp = ts.rateByValue();
    k_.dvmdm = ts.steady() ? 0 : ts.velocityByUnknown()/ts.displacementByUnknown();
    k_.deltaT = ts.steady() ? GREAT : ts.deltaT();
}


template<class F>
void Foam::aleFluid::addLoad
(
    const elementBlock& block,
    const vector& traction,
    const scalar pressure,
    const scalar backflow,
    feMatrix* K
)
{
    constexpr int dim = F::dim + 1;
    typedef Vec<double, dim> vec;
    faceValues<double, F> face;
    const scalar columns = timeScheme().alphaF();

    const auto inPlane = [&](const vector& u)
    {
        vec v;
        for (int a = 0; a < dim; ++a) v[a] = u[fe().axis(a)];
        return v;
    };

    for (label e = 0; e < block.size(); ++e)
    {
        const label* nodes = block.element(e);
        vec x[F::nNodes], v[F::nNodes];
        for (int i = 0; i < F::nNodes; ++i)
        {
            x[i] = inPlane(stage_.x[nodes[i]]);
            v[i] = inPlane(stage_.v[nodes[i]]);
        }
        for (int q = 0; q < face.nQ; ++q)
        {
            face.reinit(x, q);
            const vec& n = face.ndA;
            const vec u = face.value(v);
            const scalar dA = ::sqrt(n & n), un = min(u & n, 0.0);

            // h = t - p n + beta rho min(v.n, 0) v
            const vec h = dA*inPlane(traction) - pressure*n + (backflow*k_.rho*un)*u;
            for (int i = 0; i < F::nNodes; ++i)
            {
                for (int a = 0; a < dim; ++a) force_[nodes[i]][fe().axis(a)] -= face.N[i]*h[a];
            }
            if (!K || un == 0) continue;

            const Ten<double, dim> dh = (backflow*k_.rho)*(un*Ten<double, dim>::I() + u*n);
            for (int i = 0; i < F::nNodes; ++i) for (int j = 0; j < F::nNodes; ++j)
            {
                for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b)
                {
                    K->add
                    (
                        systemNode_[nodes[i]], a, systemNode_[nodes[j]], b,
                        -columns*face.N[i]*face.N[j]*dh(a, b)
                    );
                }
            }
        }
    }
}


void Foam::aleFluid::addLoads(feMatrix* K)
{
    const scalar t = stageTime();
    forAll(pointU_->boundaryField(), patchi)
    {
        const surfaceLoad* load =
            dynamic_cast<const surfaceLoad*>(&pointU_->boundaryField()[patchi]);
        if (!load) continue;
        for (const elementBlock& block : fe().patchBlocks(patchi))
        {
            withFaceElement(block, [&](auto F)
            {
                if (F.dim != fe().dim() - 1) return;
                addLoad<decltype(F)>
                (
                    block, load->traction(t), load->pressure(t), load->backflow(), K
                );
            });
        }
    }
}


void Foam::aleFluid::addSource()
{
    const scalar t = stageTime();
    for (const elementBlock& block : fe().blocks())
    {
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            if (E::dim != fe().dim()) return;
            feValues<double, E> w;
            Vec<double, E::dim> x[E::nNodes];
            for (label e = 0; e < block.size(); ++e)
            {
                const label* n = block.element(e);
                for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
                {
                    x[i][a] = stage_.x[n[i]][fe().axis(a)];
                }
                for (int q = 0; q < w.nQ; ++q)
                {
                    w.reinit(x, q);
                    point X = Zero;
                    for (int i = 0; i < E::nNodes; ++i) X += w.N[i]*stage_.x[n[i]];
                    const vector f = source(X, t)*w.dV;
                    for (int i = 0; i < E::nNodes; ++i) force_[n[i]] -= w.N[i]*f;
                }
            }
        });
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aleFluid::assemble(scalarField& R, feMatrix* K)
{
    const feTimeScheme& ts = timeScheme();
    stage();
    force_ = Zero;
    continuity_ = 0;

    if (K && S_.valid()) S_->clear();
    flowMatrices to;
    to.K = K;
    to.S = S_.get();
    to.scatter = &scatter_;
    to.shapeScatter = &shapeScatter_;
    to.columns = ts.alphaF();
    if (ts.steady() && !interface_.empty())
    {
        to.heldNodes.setSize(fe().nNodes(), false);
        for (const label n : interface_) to.heldNodes[n] = true;
    }
    minDetJ_ = assembly_.assemble(k_, stage_, force_, continuity_, K ? &to : nullptr);

    addLoads(K);
    if (source) addSource();

    addVector(force_, R);
    forAll(continuity_, n)
    {
        if (pressureNode(n)) R[map_->start(systemNode_[n]) + fe().dim()] += continuity_[n];
    }
}


void Foam::aleFluid::addMotionTangent(const scalarField& dx, scalarField& y)
{
    const feTimeScheme& ts = timeScheme();
    const label dim = fe().dim();

    // Interface, interior, residual
    const scalar dDdx = ts.displacementByUnknown()/ts.alphaF();
    shapeD_ = Zero;
    for (const label n : interface_)
    {
        const label start = map_->start(systemNode_[n]);
        for (label a = 0; a < dim; ++a) shapeD_[n][fe().axis(a)] = dDdx*dx[start + a];
    }
    motion_->extend(shapeD_);
    forAll(shapeD_, n) for (label a = 0; a < dim; ++a)
    {
        shapeX_[shapeColumns_->start(n) + a] = shapeD_[n][fe().axis(a)];
    }
    S_->multiply(shapeX_, shapeY_);
    y += shapeY_;
}


// ************************************************************************* //
