/* A part of a driver that does nothing. */
int stand_in_part(void);
int stand_in_part(void)
{
    return 0;
}
