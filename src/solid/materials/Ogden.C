/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::Ogden

Description
    Law of Ogden in the principal stretches lambda_i, of the distortion alone:

        Wiso = sum_p mu_p/alpha_p (l_1^alpha_p + l_2^alpha_p + l_3^alpha_p - 3)
        l_i = J^(-1/3) lambda_i

    with the shear modulus sum_p mu_p alpha_p/2, which must be positive. With
    the eigenvalues e_i = lambda_i^2 and eigenvectors n_i of C = F^T F

        Piso = F S,  S = sum_i s_i n_i n_i,
        s_i = 1/e_i sum_p mu_p (l_i^alpha_p - m_p),  m_p = sum_k l_k^alpha_p/3

    The derivative has (s_i - s_j)/(e_i - e_j), which is computed from powers
    without a difference of near numbers, so that equal stretches are no matter.

Usage
    \verbatim
    rubber
    {
        type            Ogden;
        rho             1100;               // kg/m3
        bulkModulus     2e9;                // Pa, absent: incompressible
        mu              (6.3e5 1.2e3 -1e4); // Pa, six terms at most
        alpha           (1.3 5 -2);
    }
    \endverbatim

    Source: R.W. Ogden, Proc. R. Soc. Lond. A 326 (1972) 565-584; J.C. Simo, R.L.
    Taylor, Comput. Meth. Appl. Mech. Engng 85 (1991) 273-310.
\*---------------------------------------------------------------------------*/

#include "mixedMaterialOf.H"
#include "symmetricEigen.H"
#include "scalarList.H"

namespace Foam
{
namespace solidLaws
{

struct Ogden
{
    static constexpr int maxTerms = 6;

    int n;
    double mu[maxTerms], alpha[maxTerms];

    explicit Ogden(const dictionary& dict)
    {
        const scalarList m(dict.get<scalarList>("mu")), a(dict.get<scalarList>("alpha"));
        n = m.size();
        bool good = n > 0 && n <= maxTerms && a.size() == n;
        for (const scalar ai : a) good = good && ai != 0;
        if (!good)
        {
            FatalIOErrorInFunction(dict)
                << "Found mu " << m << " and alpha " << a << ", expected two lists of"
                << " one length, 1 to " << maxTerms << ", and no alpha that is nil"
                << exit(FatalIOError);
        }
        for (int p = 0; p < n; ++p) { mu[p] = m[p]; alpha[p] = a[p]; }
    }

    static wordList entries() { return {"mu", "alpha"}; }

    scalar shearModulus() const
    {
        scalar sum = 0;
        for (int p = 0; p < n; ++p) sum += 0.5*mu[p]*alpha[p];
        return sum;
    }

    template<class T, int d>
    T Wiso(const Ten<T, d>& F) const
    {
        const principal<T, d> at(F);
        T W(0.0);
        for (int p = 0; p < n; ++p) W += (3.0*mu[p]/alpha[p])*(at.powers(alpha[p]).mean - 1.0);
        return W;
    }

    template<class T, int d>
    Ten<T, d> Piso(const Ten<T, d>& F) const
    {
        const principal<T, d> at(F);
        return F & stress(at);
    }

    template<class T, int d>
    Ten<T, d> dPiso(const Ten<T, d>& F, const Ten<T, d>& dF) const
    {
        const principal<T, d> at(F);
        const Ten<T, d> FtdF = F.t() & dF;
        return (dF & stress(at)) + (F & dStress(at, Ten<T, d>(FtdF + FtdF.t())));
    }


private:

    //- Principal values of C; in plane strain the third is 1
    template<class T, int d>
    struct principal : symmetricEigen<T, d>
    {
        //- Logarithms of the values, and of them without the change of volume
        T ln[3], lnIso[3];

        explicit principal(const Ten<T, d>& F) : symmetricEigen<T, d>(Ten<T, d>(F.t() & F))
        {
            using std::log;
            T mean(0.0);
            for (int i = 0; i < 3; ++i)
            {
                ln[i] = i < d ? log(this->c[i%d]) : T(0.0);
                mean += ln[i]/3.0;
            }
            for (int i = 0; i < 3; ++i) lnIso[i] = ln[i] - mean;
        }

        struct powersOf { T l[3], mean; };

        //- l_i^alpha
        powersOf powers(const double alpha) const
        {
            using std::exp;
            powersOf q;
            q.mean = T(0.0);
            for (int i = 0; i < 3; ++i)
            {
                q.l[i] = exp(0.5*alpha*lnIso[i]);
                q.mean += q.l[i]/3.0;
            }
            return q;
        }

        //- Q A Q^T
        Ten<T, d> turned(const Ten<T, d>& A) const { return this->Q & (A & this->Q.t()); }
    };

    //- (x^b - 1)/(x - 1) for x = e^t
    template<class T>
    static T slope(const double b, const T& t)
    {
        using std::expm1;
        const T x = expm1(t);
        T s = T(b);
        stdx::where(x != 0.0, s) = expm1(b*t)/x;
        return s;
    }

    template<class T, int d>
    Ten<T, d> stress(const principal<T, d>& at) const
    {
        Ten<T, d> S = Ten<T, d>::zero();
        for (int p = 0; p < n; ++p)
        {
            const auto q = at.powers(alpha[p]);
            for (int i = 0; i < d; ++i) S(i, i) += mu[p]*(q.l[i] - q.mean)/at.c[i];
        }
        return at.turned(S);
    }

    template<class T, int d>
    Ten<T, d> dStress(const principal<T, d>& at, const Ten<T, d>& dC) const
    {
        const Ten<T, d> dE = at.Q.t() & (dC & at.Q);
        Ten<T, d> dS = Ten<T, d>::zero();
        for (int p = 0; p < n; ++p)
        {
            const auto q = at.powers(alpha[p]);
            for (int i = 0; i < d; ++i) for (int j = 0; j < d; ++j)
            {
                const T rcc = 1.0/(at.c[i]*at.c[j]);
                const T cross = 0.5*alpha[p]*(q.mean - q.l[i] - q.l[j])/3.0;
                dS(i, i) += mu[p]*(rcc*dE(j, j))*cross;
                if (i == j) dS(i, i) += mu[p]*(rcc*dE(i, i))*((0.5*alpha[p] - 1.0)*q.l[i] + q.mean);
                else
                {
                    const T dd = q.l[j]*slope(0.5*alpha[p] - 1, T(at.ln[i] - at.ln[j]));
                    dS(i, j) += mu[p]*dE(i, j)*(dd/(at.c[j]*at.c[j]) + q.mean*rcc);
                }
            }
        }
        return at.turned(dS);
    }
};


struct OgdenMaterial : mixedMaterialOf<Ogden>
{
    explicit OgdenMaterial(const dictionary& dict)
    :
        mixedMaterialOf<Ogden>(dict, Ogden(dict), Ogden::entries())
    {}
};

addNamedToRunTimeSelectionTable(solidMaterial, OgdenMaterial, dictionary, Ogden);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
