
int main()
{
    const double x[] = {0.0, 1.0, 2.0}, f[] = {0.0, 10.0, 4.0};
    return fragility::peak({x, f}).force == 10.0 ? 0 : 1;
}
