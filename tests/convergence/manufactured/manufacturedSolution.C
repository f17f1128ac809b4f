/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "manufacturedSolution.H"
#include "mathematicalConstants.H"
#include "error.H"
#include "wordList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

using constant::mathematical::pi;

static const scalar h = 0.01;

//- First and second derivatives at 0 of a function of one number
template<class F>
static auto derivative(const F& f)
{
    return
        (1/(60*h))
       *(45.0*(f(h) - f(-h)) - 9.0*(f(2*h) - f(-2*h)) + (f(3*h) - f(-3*h)));
}

template<class F>
static auto secondDerivative(const F& f)
{
    return
        (1/(180*sqr(h)))
       *(
            270.0*(f(h) + f(-h)) - 27.0*(f(2*h) + f(-2*h)) + 2.0*(f(3*h) + f(-3*h))
          - 490.0*f(0)
        );
}


//- First Piola-Kirchhoff stress
static tensor stress(const dictionary& material, const tensor& F)
{
    const scalar E = material.get<scalar>("E"), nu = material.get<scalar>("nu");
    const scalar mu = E/(2*(1 + nu)), lambda = E*nu/((1 + nu)*(1 - 2*nu));

    if (material.get<word>("type") == "StVenantKirchhoff")
    {
        const tensor G = 0.5*((F.T() & F) - tensor::I);
        return F & (lambda*tr(G)*tensor::I + 2*mu*G);
    }
    const scalar J = det(F);
    const tensor FinvT = inv(F).T();
    return mu*(F - FinvT) + 0.5*lambda*(sqr(J) - 1)*FinvT;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

Foam::autoPtr<Foam::manufacturedSolution> Foam::manufacturedSolution::theSolution;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class F>
auto Foam::manufacturedSolution::ddx(const F& f, const point& x, const label a) const
{
    return derivative([&](const scalar s)
    {
        point y = x;
        y[a] += s;
        return f(y);
    });
}


template<class F>
Foam::tensor Foam::manufacturedSolution::grad(const F& f, const point& x) const
{
    tensor g = Zero;
    for (label a = 0; a < dim_; ++a)
    {
        const vector df = ddx(f, x, a);
        for (label i = 0; i < dim_; ++i) g(i, a) = df[i];
    }
    return g;
}


Foam::vector Foam::manufacturedSolution::V(const point& x, const scalar t) const
{
    return derivative([&](const scalar s) { return D(x, t + s); });
}


Foam::vector Foam::manufacturedSolution::flowForce
(
    const point& x,
    const scalar t,
    const scalar rho,
    const scalar mu
) const
{
    // The velocity has no divergence
    vector f = rho*derivative([&](const scalar s) { return U(x, t + s); });
    const vector u = U(x, t);
    for (label a = 0; a < dim_; ++a)
    {
        f += rho*u[a]*ddx([&](const point& y) { return U(y, t); }, x, a);
        f[a] += ddx([&](const point& y) { return p(y, t); }, x, a);
        f -= mu*secondDerivative([&](const scalar s)
        {
            point y = x;
            y[a] += s;
            return U(y, t);
        });
    }
    return f;
}


Foam::vector Foam::manufacturedSolution::solidForce
(
    const point& x,
    const scalar t,
    const dictionary& material
) const
{
    const auto P = [&](const point& y) { return solidStress(y, t, material); };
    vector f = material.get<scalar>("rho")
       *secondDerivative([&](const scalar s) { return D(x, t + s); });
    for (label a = 0; a < dim_; ++a)
    {
        const tensor dP = ddx(P, x, a);
        for (label i = 0; i < dim_; ++i) f[i] -= dP(i, a);
    }
    return f;
}


Foam::tensor Foam::manufacturedSolution::flowStress(const point& x, const scalar t) const
{
    const tensor L(grad([&](const point& y) { return U(y, t); }, x));
    return -p(x, t)*tensor::I + mu*(L + L.T());
}


Foam::tensor Foam::manufacturedSolution::solidStress
(
    const point& x,
    const scalar t,
    const dictionary& material
) const
{
    return stress(material, tensor::I + grad([&](const point& y) { return D(y, t); }, x));
}


Foam::vector Foam::manufacturedSolution::interfaceLoad
(
    const point& X,
    const scalar t,
    const vector& N
) const
{
    const tensor F(tensor::I + grad([&](const point& y) { return D(y, t); }, X));
    const vector n(det(F)*(inv(F).T() & N));
    return (solidStress(X, t, material) & N) - (flowStress(X + D(X, t), t) & n);
}


// * * * * * * * * * * * * * * * * Solutions * * * * * * * * * * * * * * * * //

namespace Foam
{

class smoothSolution : public manufacturedSolution
{
public:

    using manufacturedSolution::manufacturedSolution;

    virtual vector U(const point& x, const scalar) const
    {
        const scalar a = 0.5*pi;
        const vector X = a*x;
        return vector
        (
            a*sin(X.x())*cos(X.y()),
            -a*cos(X.x())*sin(X.y()),
            dim() == 3 ? sin(X.x())*cos(X.y()) : 0
        );
    }

    virtual scalar p(const point& x, const scalar) const
    {
        return cos(0.5*pi*x.x())*sin(pi*x.y());
    }

    virtual vector D(const point& x, const scalar t) const
    {
        const scalar z = dim() == 3 ? cos(0.5*pi*x.z()) : 1;
        return 0.04*t*vector
        (
            sin(0.5*pi*x.x() + 0.3)*cos(pi*x.y())*z,
            cos(pi*x.x())*sin(0.5*pi*x.y() + 0.2)*z,
            dim() == 3 ? sin(pi*x.x())*cos(0.5*pi*x.z()) : 0
        );
    }
};


class transportedSolution : public smoothSolution
{
public:

    using smoothSolution::smoothSolution;

    //- A function of the stream function
    virtual scalar p(const point& x, const scalar) const
    {
        return sin(2*sin(0.5*pi*x.x())*sin(0.5*pi*x.y()));
    }
};


class KovasznaySolution : public manufacturedSolution
{
    static constexpr scalar Re = 10;
    const scalar lambda_ = 0.5*Re - sqrt(0.25*sqr(Re) + 4*sqr(pi));

public:

    using manufacturedSolution::manufacturedSolution;

    virtual vector U(const point& x, const scalar) const
    {
        const scalar e = exp(lambda_*x.x()), Y = 2*pi*x.y();
        return vector(1 - e*cos(Y), lambda_/(2*pi)*e*sin(Y), 0);
    }

    virtual scalar p(const point& x, const scalar) const { return -0.5*exp(2*lambda_*x.x()); }

    virtual vector D(const point&, const scalar) const { return Zero; }
};


class polynomialSolution : public manufacturedSolution
{
    static scalar T(const scalar t) { return pow3(sin(1.5*t)); }

public:

    using manufacturedSolution::manufacturedSolution;

    virtual vector U(const point& x, const scalar t) const
    {
        const scalar xi = 1 - x.x(), y = x.y();
        return T(t)*vector(3*sqr(y) + 3*sqr(xi), 6*xi*y, 0);
    }

    virtual scalar p(const point& x, const scalar t) const
    {
        return 10*T(t)*(1 + t)*(1 - x.x());
    }

    virtual vector D(const point& x, const scalar t) const
    {
        return 0.1*T(t)*vector(sqr(x.x()) + x.y(), sqr(x.y()) - x.x()*x.y(), 0);
    }
};


class wallSolution : public manufacturedSolution
{
    static constexpr scalar A = 0.05;

public:

    using manufacturedSolution::manufacturedSolution;

    //- The curl of psi = e^2 phi/2, e the distance below the wall
    virtual vector U(const point& x, const scalar) const
    {
        const scalar e = 1 + A*sin(pi*x.x()) - x.y(), dedx = A*pi*cos(pi*x.x());
        const scalar phi = 1 + 0.3*sin(2*x.x() + x.y()), d = 0.3*cos(2*x.x() + x.y());
        return vector(0.5*sqr(e)*d - e*phi, -sqr(e)*d - e*dedx*phi, 0);
    }

    virtual scalar p(const point& x, const scalar) const
    {
        return 2*cos(2*x.x())*sin(1 + x.y());
    }

    virtual vector D(const point& x, const scalar) const
    {
        const scalar y = x.y() - 1;
        return A*vector(2*y*(1 - y)*sin(2*pi*x.x()), sin(pi*x.x())*cos(0.5*pi*y), 0);
    }
};

} // End namespace Foam


Foam::autoPtr<Foam::manufacturedSolution> Foam::manufacturedSolution::New
(
    const word& name,
    const label dim
)
{
    if (name == "Kovasznay") return autoPtr<manufacturedSolution>(new KovasznaySolution(dim));
    if (name == "polynomial") return autoPtr<manufacturedSolution>(new polynomialSolution(dim));
    if (name == "transported") return autoPtr<manufacturedSolution>(new transportedSolution(dim));
    if (name == "wall") return autoPtr<manufacturedSolution>(new wallSolution(dim));
    if (name != "smooth")
    {
        FatalErrorInFunction
            << "Unknown solution " << name << ". Valid: (Kovasznay polynomial smooth transported wall)" << exit(FatalError);
    }
    return autoPtr<manufacturedSolution>(new smoothSolution(dim));
}


// ************************************************************************* //
