/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::fibreReinforced

Description
    Transversely isotropic: a neo-Hookean matrix with fibres of direction a,
    which carry tension only:

        Wiso = mu/2 (I~ - 3) + k1/(2 k2) (exp(k2 e^2) - 1),   e = <I4~ - 1>
        I4~ = J^(-2/3) |F a|^2

    <e> = e if e > 0, else 0. Stretched along the fibres the material has, beside
    the matrix, Young's modulus 4 k1 of small strains.

Usage
    \verbatim
    tendon
    {
        type            fibreReinforced;
        rho             1100;       // kg/m3
        bulkModulus     2e9;        // Pa, absent: incompressible
        mu              1e5;        // shear modulus of the matrix, Pa
        k1              2e5;        // Pa
        k2              1.5;        // -
        direction       (1 0 0);    // a, any length, in the undeformed body
    }
    \endverbatim

    Source: G.A. Holzapfel, T.C. Gasser, R.W. Ogden, J. Elasticity 61 (2000)
    1-48, for one family of fibres.
\*---------------------------------------------------------------------------*/

#include "mixedMaterialOf.H"
#include "readNumber.H"

namespace Foam
{
namespace solidLaws
{

struct fibreReinforced
{
    double mu, k1, k2;

    //- Direction of the fibres, in the directions of the case
    Vec<double, 3> a;

    explicit fibreReinforced(const dictionary& dict)
    :
        mu(readNumber(dict, "mu", dimPressure, 0, GREAT)),
        k1(readNumber(dict, "k1", dimPressure, 0, GREAT)),
        k2(readNumber(dict, "k2", dimless, 0, GREAT))
    {
        const vector direction(dict.get<vector>("direction"));
        if (!(mag(direction) > VSMALL && mag(direction) < GREAT))
        {
            FatalIOErrorInFunction(dict)
                << "Found direction " << direction << ", expected a vector that is not nil"
                << exit(FatalIOError);
        }
        for (int i = 0; i < 3; ++i) a[i] = direction[i]/mag(direction);
    }

    static wordList entries() { return {"mu", "k1", "k2", "direction"}; }

    scalar shearModulus() const { return mu; }

    //- The first components are those of a plane case
    void setAxes(const FixedList<label, 3>& axis)
    {
        const Vec<double, 3> b = a;
        for (int i = 0; i < 3; ++i) a[i] = b[axis[i]];
    }

    template<class T, int d>
    T Wiso(const Ten<T, d>& F) const
    {
        using std::expm1;
        const invariants<T, d> at(F, a);
        return 0.5*mu*(at.r*at.I1 - 3.0) + 0.5*k1/k2*expm1(k2*at.e*at.e);
    }

    template<class T, int d>
    Ten<T, d> Piso(const Ten<T, d>& F) const
    {
        const invariants<T, d> at(F, a);
        return (0.5*mu)*at.A + (k1*at.e*grown(at.e))*at.B;
    }

    template<class T, int d>
    Ten<T, d> dPiso(const Ten<T, d>& F, const Ten<T, d>& dF) const
    {
        const invariants<T, d> at(F, a);
        T W44 = k1*(1.0 + 2.0*k2*at.e*at.e)*grown(at.e);
        stdx::where(!(at.e > 0.0), W44) = T(0.0);
        return
            (0.5*mu)*at.derivative(at.A, T(at.I1), dF, T(2.0*(F && dF)), dF)
          + (k1*at.e*grown(at.e))*at.derivative(at.B, T(at.I4), dF, at.dI4(dF), at.dFaa(dF))
          + (W44*(at.B && dF))*at.B;
    }


private:

    template<class T>
    T grown(const T& e) const
    {
        using std::exp;
        return exp(k2*e*e);
    }

    //- I~ and I4~, with A = dI~/dF = 2 J^(-2/3) (F - I/3 F^-T) and
    //  B = dI4~/dF = 2 J^(-2/3) (F a a - I4/3 F^-T)
    template<class T, int d>
    struct invariants
    {
        typedef Ten<T, d> ten;
        typedef Vec<T, d> vec;

        ten FinvT, A, B;

        //- Direction; with F
        vec a, Fa;

        //- I, I4, J^(-2/3), e
        T I1, I4, r, e;

        invariants(const ten& F, const Vec<double, 3>& direction)
        {
            using std::cbrt;
            const T J = det(F), s = 1.0/cbrt(J);
            r = s*s;
            FinvT = inv(F, J).t();
            for (int i = 0; i < d; ++i) a[i] = T(direction[i]);
            Fa = F & a;
            I1 = trPlaneStrain(ten(F.t() & F));
            I4 = Fa & Fa;
            if (d == 2) I4 += direction[2]*direction[2];
            e = r*I4 - 1.0;
            stdx::where(e < 0.0, e) = T(0.0);
            A = (2.0*r)*(F - (I1/3.0)*FinvT);
            B = (2.0*r)*(Fa*a - (I4/3.0)*FinvT);
        }

        T dI4(const ten& dF) const { return 2.0*(Fa & (dF & a)); }
        ten dFaa(const ten& dF) const { return (dF & a)*a; }

        //- Of G = 2 J^(-2/3) (H - I/3 F^-T), dI and dH being known
        ten derivative(const ten& G, const T& I, const ten& dF, const T& dI, const ten& dH) const
        {
            return
                (-2.0/3.0*(FinvT && dF))*G
              + (2.0*r)*(dH - (dI/3.0)*FinvT + (I/3.0)*(FinvT & (dF.t() & FinvT)));
        }
    };
};


struct fibreReinforcedMaterial : mixedMaterialOf<fibreReinforced>
{
    explicit fibreReinforcedMaterial(const dictionary& dict)
    :
        mixedMaterialOf<fibreReinforced>(dict, fibreReinforced(dict), fibreReinforced::entries())
    {}

    bool ofStretches() const override { return false; }
    void setAxes(const FixedList<label, 3>& axis) override { law().setAxes(axis); }
};

addNamedToRunTimeSelectionTable
(
    solidMaterial, fibreReinforcedMaterial, dictionary, fibreReinforced
);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
