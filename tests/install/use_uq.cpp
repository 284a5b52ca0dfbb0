
int main()
{
    const uq::Marginal friction{uq::Normal{0.5, 0.1}};
    return uq::quantile(friction, 0.5) == 0.5 ? 0 : 1;
}
